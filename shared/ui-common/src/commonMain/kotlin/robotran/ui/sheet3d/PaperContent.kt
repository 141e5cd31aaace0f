package robotran.ui.sheet3d

import robotran.simulation.state.LampState
import robotran.simulation.state.SessionState
import robotran.ui.sheet.goalRegions
import robotran.workshop.state.SheetLayer
import robotran.world.World

/** Everything on the paper that may change, besides ink and trails: as long as it is the same, tiles stay valid. */
internal data class PaperContent(val layers: Set<SheetLayer>, val lamps: List<LampState>, val met: List<Boolean>) {
    companion object {
        private val ON_PAPER = setOf(SheetLayer.GRID, SheetLayer.GOALS, SheetLayer.TRAIL)

        fun of(state: SessionState, layers: Set<SheetLayer>, world: World) = PaperContent(
            layers.filterTo(mutableSetOf()) { it in ON_PAPER },
            state.lamps,
            if (SheetLayer.GOALS in layers) goalRegions(world.goals).map { it.isMet(state.goals) } else emptyList(),
        )
    }
}
