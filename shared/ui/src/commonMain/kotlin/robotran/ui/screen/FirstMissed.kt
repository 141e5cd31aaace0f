package robotran.ui.screen

import robotran.simulation.state.GoalShortfall
import robotran.workshop.state.ShortfallMark

/**
 * Of what was [missing], what went wrong first; null if nothing was. What had not begun yet has nothing to say that the
 * one before it does not.
 */
internal fun firstMissed(missing: List<ShortfallMark>): ShortfallMark? =
    missing.filterNot { it.shortfall == GoalShortfall.NotBegun }
        .minByOrNull { it.shortfall.moment?.milliseconds ?: Long.MAX_VALUE }
