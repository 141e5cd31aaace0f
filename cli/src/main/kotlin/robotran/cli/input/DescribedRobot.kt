package robotran.cli.input

import robotran.cli.console.Console
import robotran.cli.console.messages
import robotran.cli.files.TextFile
import robotran.cli.files.readTextFile
import robotran.world.RobotDescription
import robotran.world.file.RobotFileResult
import robotran.world.file.readRobot

/** The result of reading a robot file. */
internal sealed interface DescribedRobot {
    data class Read(val robot: RobotDescription) : DescribedRobot

    /**
     * The robot cannot be used. [reason] is a sentence that names the file.
     *
     * @property isReadable whether the file could be read, and the robot has a mistake.
     */
    data class Rejected(val reason: String, val isReadable: Boolean) : DescribedRobot
}

/** Reads the robot file [name]. */
internal fun readDescribedRobot(name: String, console: Console): DescribedRobot =
    when (val file = readTextFile(name, console.messages)) {
        is TextFile.Rejected -> {
            DescribedRobot.Rejected(file.reason, isReadable = false)
        }

        is TextFile.Read -> {
            when (val result = readRobot(file.text, console.language)) {
                is RobotFileResult.Loaded -> DescribedRobot.Read(result.robot)

                is RobotFileResult.Rejected -> {
                    val line = result.line?.let { ":$it" }.orEmpty()
                    DescribedRobot.Rejected("$name$line: ${result.message}", isReadable = true)
                }
            }
        }
    }
