package robotran.json

import robotran.language.Language

/**
 * Stops the reading of a file; [readJson] always catches it.
 *
 * @property path the invalid value; null if [reason] needs none.
 * @property reason what is wrong, in any language, to follow the path: `must be a number`. A whole sentence if there is
 * no path, or if it [isSentence].
 */
class JsonValidationException(val path: JsonPath?, val isSentence: Boolean, val reason: (Language) -> String) :
    Exception(reason(Language.ENGLISH)) {
    constructor(path: JsonPath?, reason: (Language) -> String) : this(path, isSentence = false, reason)
}
