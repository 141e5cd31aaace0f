package robotran.ui.program

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*

/** The numbers of one to three [ports], as in `1, 2 and 3`. */
@Composable
internal fun portNumbers(ports: List<Int>): String = when (ports.size) {
    1 -> "${ports.single()}"
    2 -> stringResource(Res.string.run_ports_two, ports[0], ports[1])
    else -> stringResource(Res.string.run_ports_three, ports[0], ports[1], ports[2])
}
