package robotran.json

import robotran.language.Language

/**
 * Stops the reading of a file; [readJson] always catches it.
 *
 * @property path the invalid value; null if [reason] needs none.
 * @property reason what is wrong, in any language, in the [form].
 */
class JsonValidationException(val path: JsonPath?, val form: Form, val reason: (Language) -> String) :
    Exception(reason(Language.ENGLISH)) {
    constructor(path: JsonPath?, reason: (Language) -> String) : this(path, Form.REASON, reason)

    /** How a reason is said. */
    enum class Form {
        /** It follows the path: `must be a number`. A whole sentence if there is no path. */
        REASON,

        /** A whole sentence, to be said with the path. */
        SENTENCE,

        /** A whole sentence that needs no path. */
        WHOLE,
    }
}
