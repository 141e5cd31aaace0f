package robotran.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import robotran.cli.console.messages
import robotran.cli.input.DescribedRobot
import robotran.cli.input.readDescribedRobot
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking

/** `robotran robot FILE..`: checks descriptions of robots. */
internal class RobotCommand(private val process: Console) : CoreCliktCommand("robot") {
    private val files by argument("FILE", help = "descriptions of robots (.robot.json)").multiple(required = true)
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) = "Tells whether robots can be built as their files say."

    override fun run() {
        throw ProgramResult(files.maxOf { check(it).status })
    }

    private fun check(file: String): ExitCode = when (val read = readDescribedRobot(file, console)) {
        is DescribedRobot.Success -> {
            console.say(console.messages.robotIsFine(file, read.robot.title, read.robot.brick))
            ExitCode.DONE
        }

        is DescribedRobot.Failure -> {
            console.complain(read.reason)
            if (read.isReadable) ExitCode.PROGRAM_FAILED else ExitCode.BAD_INPUT
        }
    }
}
