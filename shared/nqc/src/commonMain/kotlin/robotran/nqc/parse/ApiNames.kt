package robotran.nqc.parse

/**
 * What messages say about the names of the API.
 *
 * @property needsSecondFirmware whether a name exists for firmware 2.0 only, which is not the target.
 * @property callOf how a function is called, without the semicolon; null if it is not part of the API.
 */
internal class ApiNames(val needsSecondFirmware: (String) -> Boolean, val callOf: (String) -> String?)
