package robotran.cli.brick

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option

/** `--port`: where the tower is. */
internal fun ParameterHolder.portOption() = option(
    "--port",
    metavar = "NAME",
    help = "where the tower is, such as COM3 or /dev/ttyUSB0; auto, which is meant if not given, looks for it",
).default(AUTO)

/** Stands for the first port that is a tower. */
internal const val AUTO = "auto"
