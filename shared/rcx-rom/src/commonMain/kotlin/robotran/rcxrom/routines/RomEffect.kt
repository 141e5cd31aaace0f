package robotran.rcxrom.routines

import robotran.rcxrom.log.RomOutcome

/** What a routine says of one call of it: the [meaning] in words, and what came of it. */
internal data class RomEffect(val meaning: String, val outcome: RomOutcome = RomOutcome.DONE)

/**
 * The work of one routine; the arguments are words 0..0xFFFF, at least as many as it has parameters, the first of the
 * right group.
 */
internal typealias RomRoutine = (arguments: List<Int>) -> RomEffect

/** Says that a call has arguments a real brick could not do anything sensible with either. */
internal fun refused(meaning: String) = RomEffect(meaning, RomOutcome.WRONG_ARGUMENTS)
