package robotran.rcxrom.routines

import robotran.brick.log.CallOutcome

/** The result of one call of a routine: its [meaning] in words and its outcome. */
internal data class RomEffect(val meaning: String, val outcome: CallOutcome = CallOutcome.DONE)

/**
 * The implementation of one routine. The arguments are words 0..0xFFFF, at least as many as it has parameters; the code
 * group of the first one is already checked.
 */
internal typealias RomRoutine = (arguments: List<Int>) -> RomEffect

/** The result for arguments that a real brick could not use either. */
internal fun refused(meaning: String) = RomEffect(meaning, CallOutcome.WRONG_ARGUMENTS)
