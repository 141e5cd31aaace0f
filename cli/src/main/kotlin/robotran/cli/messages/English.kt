package robotran.cli.messages

import robotran.language.Language
import robotran.language.listed
import robotran.simulation.messages.EnglishSimulationMessages

/** The messages in English. */
internal object EnglishCommandMessages :
    CommandMessages,
    FileMessages by EnglishFileMessages,
    RunMessages by EnglishRunMessages,
    RobotMessages by EnglishRobotMessages,
    GradeMessages by EnglishGradeMessages,
    TowerMessages by EnglishTowerMessages,
    WebMessages by EnglishWebMessages,
    OutputMessages by EnglishOutputMessages

private object EnglishFileMessages : FileMessages {
    override val language = Language.ENGLISH

    override fun noFile(name: String) = "There is no file $name."

    override fun notAllowed(name: String) = "$name could not be read: that is not allowed."

    override fun notText(name: String) = "$name is not a text."

    override fun notAJar(name: String) = "$name is no jar, or a damaged one."

    override fun unreadable(name: String, why: String) = "$name could not be read: $why"

    override fun isFolder(name: String) = "$name is a folder, not a file."

    override fun isDevice(name: String) =
        "$name is not a file with an end but a device or a pipe, which cannot be read."

    override fun fileTooLarge(name: String, bytes: Long) = "$name is too large: it can have $bytes bytes at most."

    override fun noClassFile(name: String) = "There is no class file in $name."

    override fun sourceCounts(name: String) = "In $name, the Java files count, and the compiled classes do not."

    override fun tooManyClasses(name: String, limit: Int) = "$name has too many classes: a brick takes $limit."

    override fun classFileTooLarge(name: String, bytes: Int) =
        "$name is too large: a class file can have $bytes bytes at most."

    override fun jarTooLarge(name: String, bytes: Int) =
        "$name is too large: unpacked it can have $bytes bytes at most."

    override fun tooManyPrograms(limit: Int, given: Int) =
        "A brick takes $limit programs at most, and these are $given."

    override fun notAProgram(name: String, endings: List<String>) =
        "$name is no program: its name does not end in ${listed(endings, "or")}, and it is no folder."

    override fun includesOutside(name: String, line: Int, included: String) =
        "$name:$line: it includes $included, which is not in the program's own folder. Copy that file there."

    override fun leadsOutside(name: String) = "$name is a link to a file outside of its folder, and is not read."

    override fun theLink() = "The link"

    override fun noProgramIn(name: String, robot: String) = "$name has no program for its robot $robot."

    override fun notRobolang(name: String, ending: String) =
        "$name is not a Robolang program: its name does not end in $ending."

    override fun notToBeChecked(name: String, endings: List<String>) =
        "$name cannot be checked: its name does not end in ${listed(endings, "or")}."

    override fun compiled(name: String) =
        "$name is compiled: a link takes programs as they were written, .robo or .java."
}

private object EnglishRunMessages : RunMessages {
    override fun noMistakes(name: String) = "$name has no mistakes."

    override fun warning(line: String) = "$line (a warning)"

    override fun refusedByBrick(reason: String) = "A real brick would refuse this program. $reason"

    override fun imageBuilt(name: String?, bytes: String, left: String): String {
        val sentence = name?.let { "$it has $bytes bytes." } ?: "The program takes $bytes bytes of the brick's memory."
        return "$sentence On the brick, $left bytes are left for objects, arrays and texts."
    }

    override fun firmwareImageBuilt(name: String?, bytes: String, limit: String) =
        name?.let { "$it is written. " }.orEmpty() +
            "The program takes $bytes of the $limit bytes that a brick has for all programs and the datalog."

    override fun notFormatted(name: String) = "$name is not formatted."

    override fun notInUtf8(name: String, encoding: String) = "$name is in $encoding, not in UTF-8."

    override fun nowInUtf8(name: String, encoding: String) = "$name was in $encoding and is in UTF-8 now."

    override fun needsDesktopApp() = "Windows and pictures need the desktop app, which ./robotran builds and starts."

    override fun projectHasItsOwn() =
        "A project has a world and programs of its own: --robot goes with it only together with --world."

    override fun firstRobotNamed(name: String) =
        "The robot $name is the first one: its programs are named without --robot."

    override fun romLogLacks(calls: Long) = "The ROM log lacks the first $calls calls: it keeps only the newest."

    override fun nothingStrayed() = "Nothing has made the robot stray."

    override fun ended(seconds: String) = "The program ended after $seconds s."

    override fun timeUp(seconds: String) = "The time was up after $seconds s."

    override fun failed(seconds: String) = "The program failed after $seconds s."

    override fun robotIsAt(x: String, y: String, heading: String, ink: String) =
        "The robot is at x $x cm, y $y cm, heading $heading degrees; it drew $ink cm."

    override fun goalMet(goal: String) = "${EnglishSimulationMessages.met()}: $goal"

    override fun goalNotMet(goal: String, percent: Int) = "${EnglishSimulationMessages.notMet()} ($percent %): $goal"

    override fun atTime(seconds: String) = "at $seconds s"

    override fun atPlace(x: String, y: String) = "at x $x cm, y $y cm"

    override fun atLine(line: Int) = "in line $line"

    override fun atLineOf(file: String, line: Int) = "in line $line of $file"
}

private object EnglishGradeMessages : GradeMessages {
    override fun noGoals(world: String) = "The world $world has no goals, so there is nothing to grade."

    override fun noHandIns() = "There are no hand-ins in what was named."

    override fun pageWithoutPictures() =
        "The page has no pictures: they need the desktop app, which ./robotran builds and starts."

    override fun noRobot(name: String) = "No robot in this world is called $name."

    override fun goalColumns() = listOf("goal", "seeds met", "worst")

    override fun programColumns() = listOf("program", "seeds passed", "first goal that was missed")

    override fun countOf(some: Int, all: Int) = "$some of $all"

    override fun cannotRun() = "It cannot run: it has mistakes."

    override fun cannotBeUsed() = "It cannot be used."

    override fun numberedLink(number: Int) = "link $number"

    override fun seeds(first: Int, last: Int) = if (first == last) "seed $first" else "seeds $first to $last"

    override fun meetsAll(program: String, seeds: String) = "$program meets all goals with $seeds."

    override fun meetsSome(program: String, passed: Int, all: Int, seeds: String) =
        "$program meets all goals with $passed of $all seeds ($seeds)."

    override fun seedMissed(seed: Int, goal: String?, percent: String) =
        if (goal == null) "Seed $seed: no goal" else "Seed $seed: \"$goal\" was not met ($percent)"

    override fun seedFailed(missed: String, error: String) = "$missed. The program failed: $error"

    override fun noGoal() = "no goal"

    override fun programFailed(error: String) = "The program failed: $error"

    override fun moreSeeds(count: Int, seeds: String) = "And $count more: seeds $seeds."

    override fun runsDone(done: Int, all: Int) = "$done of $all runs"
}

private object EnglishWebMessages : WebMessages {
    override fun notAnAssignment(name: String) =
        "$name is no assignment. \"Make an assignment\" in the app makes one of it."

    override fun noSuchCourse(name: String, known: List<String>) =
        "There is no course called $name. There are ${listed(known, "and")}."

    override fun isCourse(name: String) = "$name is a whole course. Choose one of its assignments."

    override fun siteNotBuilt(folder: String) = "There is no built site in $folder. ./gradlew :webApp:dist makes it."

    override fun siteNotHere() =
        "This Robotran has no web site with it. Serve the one of its source tree by ./robotran web, or name a folder " +
            "by --site."

    override fun portTaken(port: Int) =
        "Port $port cannot be used, perhaps because another program uses it. Choose another one by --port."

    override fun siteServed(address: String) = "Robotran is at $address for this machine alone, until you press Ctrl+C."

    override fun linksStayHere(site: String) =
        "Links that begin with $site work on this machine only; for others, put the site where they can reach it."
}
