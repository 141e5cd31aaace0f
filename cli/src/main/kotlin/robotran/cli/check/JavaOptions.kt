package robotran.cli.check

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.console.lejosOption
import robotran.programs.JavaSettings
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode

/** The options of `check` about the brick that Java is for. */
internal class JavaOptions : OptionGroup() {
    private val forgiving by option(
        "--forgiving",
        help = "accepts Java that a brick with leJOS refuses but run --forgiving runs",
    ).flag()

    /** The version of leJOS; null if not given. */
    val version by lejosOption(
        "the version of leJOS on the brick, ${LejosVersion.DEFAULT.label} if not given; " +
            "also checks the Java that a Robolang program becomes",
    )

    val java: JavaSettings
        get() = JavaSettings(
            if (forgiving) TinyVmMode.FORGIVING else TinyVmMode.BRICK,
            version = version ?: LejosVersion.DEFAULT,
        )
}
