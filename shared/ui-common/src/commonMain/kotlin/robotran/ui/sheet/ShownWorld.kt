package robotran.ui.sheet

import robotran.simulation.state.SessionState
import robotran.workshop.state.SheetViewState
import robotran.world.World

/**
 * What is shown of a world, on the sheet or in perspective.
 *
 * @property drawn what is drawn of [session]: the same, or with a robot that dances. All else goes by [session].
 */
class ShownWorld(val world: World, val session: SessionState, val drawn: SessionState, val view: SheetViewState)
