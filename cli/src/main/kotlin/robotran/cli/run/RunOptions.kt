package robotran.cli.run

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.console.lejosOption
import robotran.cli.console.oldNqcOption
import robotran.cli.console.targetOption
import robotran.cli.input.readRobotBuild
import robotran.cli.input.readRobotFile
import robotran.legofirmware.image.FirmwareTarget
import robotran.programs.FirmwareSettings
import robotran.programs.JavaSettings
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed

/** The options shared by `run` and `grade`. */
internal class RunOptions : OptionGroup() {
    private val forgiving by option(
        "--forgiving",
        help = "runs Java as the language says, not with the peculiarities of a brick",
    ).flag()
    private val unlimited by option("--unlimited", help = "runs Java much faster than a brick").flag()

    private val version by lejosOption("the version of leJOS that Java is for").default(LejosVersion.DEFAULT)

    private val target by targetOption()
    private val oldNqc by oldNqcOption()

    /** Virtual milliseconds; null if not set. */
    val milliseconds by option(
        "--for",
        metavar = "SECONDS",
        help = "virtual seconds to run at most; the world's time limit if not given",
    )
        .convert { text ->
            virtualMilliseconds(text)
                ?: fail("$text is not a number of seconds from 0 to $LONGEST_RUN_SECONDS")
        }

    /** From 0 to 1; null if not set. */
    val realism by option(
        "--realism",
        metavar = "0..1",
        help = "how much makes a robot stray, instead of what the world says",
    )
        .convert { text ->
            text.toDoubleOrNull()?.takeIf { it in 0.0..1.0 } ?: fail("$text is not a number from 0 to 1")
        }

    /** Programs for all robots but the first. */
    val robots by option(
        "--robot",
        metavar = "NAME=FILE",
        help = "a program for another robot of the world; may be given several times",
    )
        .convert { text ->
            readRobotFile(text)
                ?: fail("$text is not the name of a robot and a file, as in red=Ram.robo")
        }
        .multiple()

    /** How robots are built, instead of what the world says; an empty name is the first robot. */
    val robotFiles by option(
        "--robot-file",
        metavar = "NAME=FILE",
        help =
            "builds this robot of the world, the first one without NAME=, as FILE (.robot.json) says; may be given " +
                "several times",
    )
        .convert { text -> readRobotBuild(text) ?: fail("$text is not a file, as in red=sumo.robot.json") }
        .multiple()

    val java: JavaSettings
        get() = JavaSettings(
            if (forgiving) TinyVmMode.FORGIVING else TinyVmMode.BRICK,
            if (unlimited) TinyVmSpeed.UNLIMITED else TinyVmSpeed.BRICK,
            version,
        )

    val firmware: FirmwareSettings get() = FirmwareSettings(target, oldNqc)

    /** These options as command-line arguments, without the time. */
    val words: List<String>
        get() = buildList {
            realism?.let { addAll(listOf("--realism", it.toString())) }
            robots.forEach { addAll(listOf("--robot", "${it.robot}=${it.file}")) }
            robotFiles.forEach {
                addAll(listOf("--robot-file", if (it.robot.isEmpty()) it.file else "${it.robot}=${it.file}"))
            }
            if (forgiving) add("--forgiving")
            if (unlimited) add("--unlimited")
            if (target != FirmwareTarget.RCX2) addAll(listOf("--target", target.word.lowercase()))
            if (oldNqc) add("--old-nqc")
            if (version != LejosVersion.DEFAULT) addAll(listOf("--lejos", version.label))
        }

    private companion object {
        fun virtualMilliseconds(text: String): Int? =
            text.toDoubleOrNull()?.takeIf { it in 0.0..LONGEST_RUN_SECONDS.toDouble() }?.let { (it * 1000).toInt() }
    }
}

/** One day of virtual time: longer than any lesson, and well below the range of 32-bit milliseconds. */
internal const val LONGEST_RUN_SECONDS = 86_400
