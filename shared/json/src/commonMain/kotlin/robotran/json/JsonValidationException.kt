package robotran.json

import robotran.language.Language

/**
 * Ends the reading of a file; never leaves [readJson].
 *
 * @property path the value that is not as it should be; null if [reason] says all there is to say.
 * @property reason what is wrong, in any language, to be read behind the path: `must be a number`. A whole sentence if
 * there is no path.
 */
class JsonValidationException(val path: JsonPath?, val reason: (Language) -> String) :
    Exception(reason(Language.ENGLISH))
