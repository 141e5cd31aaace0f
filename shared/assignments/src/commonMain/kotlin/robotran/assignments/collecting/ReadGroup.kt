package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages
import robotran.json.JsonLimits
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.openHandInLink
import robotran.projects.readProject
import robotran.rcxrom.Brick

/**
 * One hand-in of a pupil, who may have handed in several.
 *
 * @property key the same for all hand-ins of one pupil.
 * @property modified in milliseconds since 1970; 0 if unknown.
 */
internal class Candidate(val key: String, val modified: Long, val submission: Submission)

/** Reads what the files of a group hold. */
internal class GroupReader(private val assignment: Project, private val language: Language) {
    private val messages = CollectingMessages.of(language)
    private val remarks = RemarkFinder(assignment)

    suspend fun read(group: FileGroup): List<Candidate> {
        val contents = GroupContents(group)
        group.files.forEach { contents.add(it) }
        return contents.candidates()
    }

    private inner class GroupContents(private val group: FileGroup) {
        private val projects = mutableListOf<Candidate>()
        private val sources = mutableListOf<Pair<FoundFile, String>>()
        private val problems = mutableListOf<String>()

        suspend fun add(file: FoundFile) {
            val bytes = when (val content = file.content) {
                is FoundContent.Ignored -> return
                is FoundContent.Problem -> return problems.plusAssign(content.reason)
                is FoundContent.Bytes -> content.bytes
            }
            val text = when {
                bytes.size > JsonLimits.MAXIMUM_BYTES -> null
                else -> textOf(bytes)
            }
            when {
                bytes.size > JsonLimits.MAXIMUM_BYTES -> {
                    problems +=
                        messages.tooLarge(file.name, JsonLimits.MAXIMUM_BYTES)
                }

                text == null -> {
                    problems += messages.notUtf8(file.name)
                }

                file.kind == FoundKind.TEXT -> {
                    addText(file, text)
                }

                isTooLong(text) -> {
                    problems += messages.programTooLong(file.name, ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS)
                }

                else -> {
                    sources += file to text
                }
            }
        }

        fun candidates(): List<Candidate> {
            val hasWork = projects.any { it.submission is Submission.Usable }
            val programs = if (hasWork) emptyList() else listOfNotNull(ofPrograms())
            val usable = projects + programs
            if (usable.isNotEmpty()) return usable
            val reason = problems.firstOrNull() ?: messages.nothingUsable()
            return listOf(candidate(null, 0, Submission.Unusable(group.name, group.origin, reason)))
        }

        private suspend fun addText(file: FoundFile, text: String) {
            if (text.trimStart().startsWith('{')) {
                when (val result = readProject(text, language)) {
                    is ProjectFileResult.Loaded -> addProject(file, result.project, group.name, file.name)
                    is ProjectFileResult.Rejected -> problems += "${file.name}: ${result.message}"
                }
                return
            }
            val links = text.lineSequence().flatMapIndexed { line, words ->
                LINK.findAll(words).map { line + 1 to it.value }
            }.take(CollectingLimits.MAXIMUM_LINKS).toList()
            for ((line, link) in links) addLink(file, link, line, isOnly = links.size == 1)
        }

        private suspend fun addLink(file: FoundFile, link: String, line: Int, isOnly: Boolean) {
            val name = if (isOnly || group.isFolder) group.name else messages.linkIn(file.name, line)
            val origin = if (isOnly) file.name else messages.linkIn(file.name, line)
            val reason = when (val result = openHandInLink(link, assignment.world, language)) {
                is LinkResult.OfProject -> return addProject(file, result.project, name, origin)
                is LinkResult.OfWorld -> messages.onlyWorld()
                is LinkResult.OfCourse -> messages.onlyCourse()
                is LinkResult.Rejected -> result.message
            }
            projects += Candidate(group.key ?: keyOf(name), 0, Submission.Unusable(name, originOf(origin), reason))
        }

        private fun addProject(file: FoundFile, project: Project, name: String, origin: String) {
            val handIn = project.handIn
            val shown = if (group.key == null && handIn != null) handIn.name else name
            val first = project.world.robots.first().name
            val robot = project.robots.firstOrNull { it.name == first }
            val submission = if (robot == null || robot.programs.isEmpty()) {
                Submission.Unusable(shown, originOf(origin), messages.noProgram(first))
            } else {
                val found = remarks.of(project) + remarks.of(robot.programs)
                Submission.Usable(shown, originOf(origin), robot, project, handIn, found)
            }
            projects += candidate(shown, file.modified ?: 0, submission)
        }

        /** All Java files are one program; of files with the same name the newest counts. */
        private fun ofPrograms(): Candidate? {
            val newest = sources.groupBy { it.first.name }.values.map { same -> same.maxBy { it.first.modified ?: 0 } }
            val (java, robolang) = newest.partition { it.first.kind == FoundKind.JAVA }
            val programs = robolang.map { (file, text) ->
                ProjectProgram(file.name, ProgramLanguage.ROBOLANG, listOf(SourceFile(file.name, text)))
            } + listOfNotNull(
                java.map { (file, text) -> SourceFile(file.name, text) }.takeIf { it.isNotEmpty() }?.let {
                    ProjectProgram(it.first().name, ProgramLanguage.JAVA, it)
                },
            )
            if (programs.isEmpty()) return null
            val modified = newest.maxOf { it.first.modified ?: 0 }
            val submission = if (programs.size > Brick.MAX_PROGRAMS) {
                val reason = messages.tooManyPrograms(programs.size, Brick.MAX_PROGRAMS)
                Submission.Unusable(group.name, group.origin, reason)
            } else {
                val robot = ProjectRobot(assignment.world.robots.first().name, programs)
                Submission.Usable(group.name, group.origin, robot, remarks = remarks.of(programs))
            }
            return candidate(null, modified, submission)
        }

        private fun candidate(name: String?, modified: Long, submission: Submission) =
            Candidate(group.key ?: keyOf(name ?: group.name), modified, submission)

        private fun originOf(file: String) = if (group.isFolder) "${group.origin}/$file" else file
    }

    private fun textOf(bytes: ByteArray): String? = try {
        bytes.decodeToString(throwOnInvalidSequence = true).removePrefix("\uFEFF")
    } catch (_: CharacterCodingException) {
        null
    }

    private fun isTooLong(text: String) = text.length > ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS ||
        text.count { it == '\n' } >= ProjectLimits.MAXIMUM_LINES

    private companion object {
        /** The part of a link that matters. */
        val LINK = Regex("#[wph]=[A-Za-z0-9_-]+")
    }
}

/** The same for names that differ only in case and blanks. */
internal fun keyOf(name: String): String = name.filterNot { it.isWhitespace() }.lowercase()
