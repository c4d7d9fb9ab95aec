// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What reading and writing frames share of HDF5: identifiers that close themselves, and silence.

#include "coronet/core/error.hpp"

#include <hdf5.h>

namespace coronet {

/// What HDF5 answered; throws RunError where that is a refusal.
template <typename Result>
Result checked(Result result) {
    if (result < 0) throw RunError("HDF5 could not compose the frame: is there memory left?");
    return result;
}

/// Owns one HDF5 identifier.
class Handle {
public:
    using Closer = herr_t (*)(hid_t);

    Handle(hid_t id, Closer closer) : id_(checked(id)), closer_(closer) {}
    Handle(Handle const&) = delete;
    Handle& operator=(Handle const&) = delete;
    ~Handle() { closer_(id_); }

    operator hid_t() const { return id_; }

private:
    hid_t id_;
    Closer closer_;
};

/// HDF5 prints its stack of errors by itself; ours are sentences, so it is kept silent meanwhile.
class SilentHdf5 {
public:
    SilentHdf5() {
        H5Eget_auto2(H5E_DEFAULT, &printer_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    SilentHdf5(SilentHdf5 const&) = delete;
    SilentHdf5& operator=(SilentHdf5 const&) = delete;
    ~SilentHdf5() { H5Eset_auto2(H5E_DEFAULT, printer_, data_); }

private:
    H5E_auto2_t printer_ = nullptr;
    void* data_ = nullptr;
};

}  // namespace coronet
