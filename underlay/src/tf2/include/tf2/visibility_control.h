#pragma once

#define TF2_EXPORT
#define TF2_IMPORT
#define TF2_PUBLIC
#define TF2_LOCAL
