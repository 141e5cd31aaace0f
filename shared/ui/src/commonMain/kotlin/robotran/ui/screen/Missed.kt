package robotran.ui.screen

import robotran.simulation.state.GoalShortfall
import robotran.workshop.state.ShortfallMark

/**
 * Of what was [missing], what there is to say, what went wrong first before the rest. What had not begun yet has nothing
 * to say that the one before it does not.
 */
internal fun missed(missing: List<ShortfallMark>): List<ShortfallMark> =
    missing.filterNot { it.shortfall == GoalShortfall.NotBegun }
        .sortedBy { it.shortfall.moment?.milliseconds ?: Long.MAX_VALUE }
