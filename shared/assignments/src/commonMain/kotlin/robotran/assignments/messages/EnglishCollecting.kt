package robotran.assignments.messages

import robotran.language.listed

internal object EnglishCollectingMessages : CollectingMessages {
    override fun notText(file: String) = "$file is not a text."

    override fun tooLarge(file: String, bytes: Int) = "$file is too large: it can have $bytes bytes at most."

    override fun programTooLong(file: String, characters: Int) =
        "$file is too long: a program can have $characters characters at most."

    override fun brokenZip(file: String) = "$file is damaged, or not a zip file at all."

    override fun zip64(file: String) = "$file is a zip file of the large kind (zip64), which cannot be read."

    override fun encrypted(file: String) = "$file has a password."

    override fun unknownCompression(file: String) = "$file is compressed in a way that cannot be read."

    override fun zipTooDeep(file: String, depth: Int) =
        "$file lies in too many zip files: $depth can be inside each other."

    override fun zipTooLarge(file: String, bytes: Int) =
        "$file becomes too large: it can unpack to $bytes bytes at most."

    override fun tooManyEntries(file: String, limit: Int) = "$file has too many files: $limit can be read."

    override fun nothingUsable() = "There is no program, no project and no link in it."

    override fun noProgram(robot: String) = "It has no program for its robot $robot."

    override fun onlyWorld() = "It is a link to a world, without a program."

    override fun onlyCourse() = "It is a link to a course, without a program."

    override fun tooManyPrograms(count: Int, limit: Int) = "It has $count programs, but a brick has room for $limit."

    override fun others() = "Others"

    override fun leftOut(count: Int, limit: Int) =
        "$count more were left out: $limit hand-ins can be looked at together."

    override fun linkIn(file: String, line: Int) = "$file, line $line"

    override fun isAssignment(file: String) = "$file is the assignment itself, not a hand-in."

    override fun isFeedback(file: String) = "$file is feedback, not a hand-in."

    override fun pastedLink(number: Int) = "Pasted link $number"

    override fun otherAssignment(title: String) = "It was handed in for another assignment: $title."

    override fun noTask() = "Nothing says which task of the course it is for. " +
        "Put the name of the task into the name of the file or a folder."

    override fun emptyFolder() = "The folder is empty."

    override fun onlyCompiled() = "There are only compiled classes in it. Ask for the Java files."

    override fun changed() = "The file was changed after it was handed in, or it is damaged."

    override fun worldChanged() =
        "The world was changed, which the assignment does not allow. It was graded in the assignment's own world."

    override fun ownWorld() =
        "The world was changed, which the assignment allows. It was graded in the assignment's own world all the same."

    override fun unchanged() = "The programs are as they were given."

    override fun sameName(count: Int, file: String) = "$count hand-ins have this name. This one is from $file."

    override fun languageNotAllowed(program: String) = "$program is in a language that the assignment does not allow."

    override fun wordsNotAllowed(words: List<String>) =
        "It uses words that the assignment does not allow: ${listed(words, "and")}."

    override fun teachersFile() = "This is your own file of the assignment."

    override fun isSolution() = "The program is the same as your solution."

    override fun otherName(entered: String) = "The hand-in says that it is from $entered."

    override fun bestCounts(chosen: String, all: List<String>) =
        "${listed(all, "and")} were run: $chosen counts, none did better."

    override fun chosenInApp(chosen: String, all: List<String>) =
        "Of ${listed(all, "and")}, $chosen counts: it was chosen in the app."

    override fun besideProject(programs: List<String>) =
        "The project counts. ${listed(programs, "and")} beside it ${if (programs.size == 1) "does" else "do"} not."

    override fun fewerTries(origins: List<String>) =
        "The hand-in with the most tries counts, without ${listed(origins, "and")}."

    override fun notTried(origins: List<String>) = "These are too many to be run, too: ${listed(origins, "and")}."

    override fun partUnusable(reason: String) = "Left out: $reason"

    override fun compiledLeftOut(classes: List<String>) =
        "The source counts, without the compiled ${listed(classes, "and")}."
}
