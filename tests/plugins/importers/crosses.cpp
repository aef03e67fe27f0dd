// SPDX-License-Identifier: Apache-2.0
// An importer whose exception crosses the border.
#include <epura/importer_abi.h>

static const char* read(const epura_source*, const epura_sink*) { throw 1; }

static const epura_importer importers[] = {
    {sizeof(epura_importer), 0, "plain", "throws", "plain", nullptr, 0, nullptr, read},
};
static const epura_importer_list list = {EPURA_IMPORTER_ABI_VERSION, sizeof(epura_importer_list), 1, importers};

const epura_importer_list* epura_importers_v1(void) { return &list; }
