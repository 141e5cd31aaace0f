package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages
import robotran.brick.program.BrickProgram
import robotran.documents.TextReading
import robotran.documents.readText
import robotran.documents.sentenceFor
import robotran.json.JsonLimits
import robotran.language.Language
import robotran.programs.ProgramSource
import robotran.programs.fault
import robotran.programs.toLasm
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.linksIn
import robotran.projects.openHandInLink
import robotran.projects.readProject

/**
 * Reads what the files of a group hold.
 *
 * @param elsewhere the IDs of assignments whose hand-ins somebody else reads.
 */
internal class GroupReader(
    private val assignment: Project,
    private val language: Language,
    private val elsewhere: Set<String> = emptySet(),
) {
    private val messages = CollectingMessages.of(language)
    private val given = GivenWork(assignment)
    private val remarks = RemarkFinder(assignment, given)

    suspend fun read(group: FileGroup): ReadFiles {
        val contents = GroupContents(group)
        group.files.forEach { contents.add(it) }
        return contents.read()
    }

    /** Whether [file] is feedback, or the assignment as the teacher has given it. */
    fun isNoHandIn(file: FoundFile): Boolean {
        val bytes = (file.content as? FoundContent.Bytes)?.bytes
        if (file.kind != FoundKind.TEXT || bytes == null || bytes.size > JsonLimits.MAXIMUM_BYTES) return false
        val text = (readText(file.name, bytes) as? TextReading.Success)?.text?.takeIf(::isProject) ?: return false
        val project = (readProject(text, language) as? ProjectFileResult.Success)?.project ?: return false
        return project.feedback != null || given.isAssignment(project)
    }

    private inner class GroupContents(private val group: FileGroup) {
        /** Made when all is read, since the names of all tell whose the folder is. */
        private val projects = mutableListOf<() -> Candidate>()
        private val sources = mutableListOf<Pair<FoundFile, String>>()
        private val problems = mutableListOf<String>()

        /** How programs were read although they are unusual. */
        private val changes = mutableListOf<String>()

        /** The assignment itself, which is a hand-in only where nothing else is. */
        private val copies = mutableListOf<() -> Candidate>()
        private val notes = mutableListOf<String>()
        private val compiled = mutableListOf<String>()

        /** What hand-ins say about whose they are, by keys. */
        private val names = mutableMapOf<String, String>()
        private var isElsewhere = false
        private val isCalledAfterPupil: Boolean
            get() = group.key != null || (group.isFolder && isNameOfOne(group.name, names.values))

        suspend fun add(file: FoundFile) {
            if (file.isClassFile) compiled += file.name
            val bytes = when (val content = file.content) {
                is FoundContent.Ignored -> return
                is FoundContent.Problem -> return problems.plusAssign(content.reason)
                is FoundContent.Bytes -> content.bytes
            }
            if (file.kind == FoundKind.RCX_IMAGE) return addImage(file, bytes)
            if (bytes.size > JsonLimits.MAXIMUM_BYTES) {
                return problems.plusAssign(messages.tooLarge(file.name, JsonLimits.MAXIMUM_BYTES))
            }
            val reading = readText(file.name, bytes) as? TextReading.Success
            val text = reading?.text
            when {
                text == null -> problems += messages.notText(file.name)
                file.kind == FoundKind.TEXT -> addText(file, text)

                isTooLong(text) -> {
                    problems += messages.programTooLong(file.name, ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS)
                }

                else -> {
                    changes += reading.changes.map { sentenceFor(it, file.name, language) }
                    sources += file.at(file.path.dropLast(1) + reading.name) to text
                }
            }
        }

        /** It becomes assembly text. */
        private fun addImage(file: FoundFile, bytes: ByteArray) {
            val image = ProgramSource.FirmwareImage(file.name, bytes)
            val lasm = image.toLasm() ?: return problems.plusAssign("${file.name}: ${image.fault(language)}")
            sources += file.at(file.path.dropLast(1) + lasm.name) to lasm.text
        }

        fun read(): ReadFiles {
            val ofProjects = projects.map { it() }
            val hasWork = ofProjects.any { it.submission is Submission.Usable }
            val programs = programsOf(sources)
            val found = if (hasWork || programs.isEmpty()) ofProjects else ofProjects + candidate(ofPrograms(programs))
            val beside = SubmissionRemark.BesideProject(programs.map { it.name }).takeIf { hasWork && programs.any() }
            val left = SubmissionRemark.CompiledLeftOut(compiled).takeIf { programs.any() && compiled.any() }
            val parts = problems.distinct().map(SubmissionRemark::PartUnusable)
            val all = found.ifEmpty { if (group.isPupils) copies.map { it() } else emptyList() }
                .map { it.with(listOfNotNull(beside, left) + parts) }
            val isNone = all.isEmpty() && !isElsewhere && (group.isPupils || problems.isNotEmpty() || notes.isEmpty())
            if (!isNone) return ReadFiles(all, notes)
            val reason = problems.firstOrNull() ?: notes.firstOrNull() ?: nothingIn()
            return ReadFiles(listOf(candidate(Submission.Unusable(group.name, group.origin, reason))), emptyList())
        }

        private fun nothingIn(): String = when {
            group.files.all { it.isEmptyFolder } -> messages.emptyFolder()
            compiled.isNotEmpty() -> messages.onlyCompiled()
            else -> messages.nothingUsable()
        }

        private suspend fun addText(file: FoundFile, text: String) {
            if (isProject(text)) {
                when (val result = readProject(text, language)) {
                    is ProjectFileResult.Success -> addProject(result.project, group.name, file.name)
                    is ProjectFileResult.Failure -> problems += "${file.name}: ${result.message}"
                }
                return
            }
            val links = linksIn(text).take(CollectingLimits.MAXIMUM_LINKS)
            for ((line, link) in links) addLink(file, link, line, isOnly = links.size == 1)
        }

        private suspend fun addLink(file: FoundFile, link: String, line: Int, isOnly: Boolean) {
            val name = if (isOnly || group.isFolder) group.name else messages.linkIn(file.name, line)
            val origin = if (isOnly) file.name else messages.linkIn(file.name, line)
            val reason = when (val result = openHandInLink(link, assignment.world, language)) {
                is LinkResult.OfProject -> return addProject(result.project, name, origin, link)
                is LinkResult.OfWorld -> messages.onlyWorld()
                is LinkResult.OfCourse -> messages.onlyCourse()
                is LinkResult.Rejected -> result.message
            }
            projects += { candidate(Submission.Unusable(name, originOf(origin), reason), link = link) }
        }

        /** @param link from which [project] came; null if it is a file. */
        private fun addProject(project: Project, name: String, origin: String, link: String? = null) {
            val isAssignment = given.isAssignment(project)
            enteredIn(project)?.takeIf { project.feedback == null }?.let { names[keyOf(it)] = it }
            when {
                project.assignment?.id in elsewhere -> isElsewhere = true
                project.feedback != null -> notes += messages.isFeedback(origin)
                isAssignment && !group.isPupils -> notes += messages.isAssignment(origin)
                else -> (if (isAssignment) copies else projects) += { candidate(project, name, origin, link) }
            }
        }

        private fun enteredIn(project: Project): String? = project.handIn?.name?.takeIf { it.isNotBlank() }

        private fun candidate(project: Project, name: String, origin: String, link: String?): Candidate {
            val entered = enteredIn(project)
            val shown = entered.takeUnless { isCalledAfterPupil } ?: name
            val first = project.world.robots.first().name
            val robot = project.robots.firstOrNull { it.name == first }
            val other = remarks.otherAssignment(project)
            val stranger = entered?.takeIf { isCalledAfterPupil && !mayBeSamePerson(it, group.name) }
            val about = remarks.of(project) + listOfNotNull(stranger?.let(SubmissionRemark::OtherName))
            val submission = when {
                other != null -> {
                    Submission.Unusable(shown, originOf(origin), messages.otherAssignment(other), about, project)
                }

                robot == null || robot.programs.isEmpty() -> {
                    Submission.Unusable(shown, originOf(origin), messages.noProgram(first), about, project)
                }

                else -> {
                    val found = about + remarks.of(robot.programs) + listOfNotNull(remarks.chosenOf(robot))
                    Submission.Usable(shown, originOf(origin), robot, project, project.handIn, found)
                }
            }
            return candidate(submission, link)
        }

        private fun ofPrograms(programs: List<ProjectProgram>): Submission {
            if (programs.size > BrickProgram.MAX_PROGRAMS) {
                val reason = messages.tooManyPrograms(programs.size, BrickProgram.MAX_PROGRAMS)
                return Submission.Unusable(group.name, group.origin, reason)
            }
            val robot = ProjectRobot(assignment.world.robots.first().name, programs)
            val unusual = changes.map(SubmissionRemark::ReadAllTheSame)
            val usable = Submission.Usable(group.name, group.origin, robot, remarks = remarks.of(programs) + unusual)
            return usable.copy(
                alternatives = programs.indices.drop(1).map { usable.copy(robot = robot.copy(firstProgram = it)) },
            )
        }

        /** @param link from which it came; null for files. */
        private fun candidate(submission: Submission, link: String? = null): Candidate {
            val place = group.key ?: if (group.isFolder) group.origin else ""
            // A folder that no platform has made may still hold what several pupils have handed in.
            val pupil = group.key ?: listOf(link.takeUnless { group.isFolder } ?: group.origin, keyOf(submission.name))
                .joinToString(" ")
            return Candidate(place, pupil, submission)
        }

        private fun originOf(file: String) = if (group.isFolder) "${group.origin}/$file" else file
    }

    private fun isTooLong(text: String) = text.length > ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS ||
        text.count { it == '\n' } >= ProjectLimits.MAXIMUM_LINES

    private fun isProject(text: String): Boolean = text.trimStart().startsWith('{')
}
