package robotran.ui.world

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.simulation.state.SessionState
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SheetViewState
import robotran.world.World

/** The world with its buttons and nothing else, on the sheet or in 3D; for windows of other apps and for measuring. */
@Composable
fun WorldView(
    world: World,
    session: SessionState,
    view: SheetViewState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) = WorldPane(world, session, view, onEvent, modifier)
