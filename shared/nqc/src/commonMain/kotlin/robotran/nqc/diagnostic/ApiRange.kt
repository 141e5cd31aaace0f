package robotran.nqc.diagnostic

import robotran.language.source.SourceRange

/** A place in the API, which has no file. */
internal val API_RANGE = SourceRange(0, 0, 0)
