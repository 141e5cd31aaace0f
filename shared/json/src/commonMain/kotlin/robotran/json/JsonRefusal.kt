package robotran.json

/**
 * Ends the reading of a file; never leaves [readJson].
 *
 * @property path the value that is not as it should be; null if [reason] says all there is to say.
 * @property reason what is wrong, to be read behind the path: `must be a number`. A whole sentence if there is no path.
 */
class JsonRefusal(val path: JsonPath?, val reason: String) : Exception(reason)
