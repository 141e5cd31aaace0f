package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages
import robotran.brick.program.BrickProgram
import robotran.documents.TextReading
import robotran.documents.readText
import robotran.documents.sentenceFor
import robotran.json.JsonLimits
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.programs.fault
import robotran.programs.nqcProgramsOf
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

/** Reads what the files of a group hold. */
internal class GroupReader(private val assignment: Project, private val language: Language) {
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
        val text = (readText(file.name, bytes) as? TextReading.Read)?.text?.takeIf(::isProject) ?: return false
        val project = (readProject(text, language) as? ProjectFileResult.Loaded)?.project ?: return false
        return project.feedback != null || given.isAssignment(project)
    }

    private inner class GroupContents(private val group: FileGroup) {
        private val projects = mutableListOf<Candidate>()
        private val sources = mutableListOf<Pair<FoundFile, String>>()
        private val problems = mutableListOf<String>()

        /** How programs were read although they are unusual. */
        private val changes = mutableListOf<String>()

        /** The assignment itself, which is a hand-in only where nothing else is. */
        private val copies = mutableListOf<Candidate>()
        private val notes = mutableListOf<String>()

        suspend fun add(file: FoundFile) {
            val bytes = when (val content = file.content) {
                is FoundContent.Ignored -> return
                is FoundContent.Problem -> return problems.plusAssign(content.reason)
                is FoundContent.Bytes -> content.bytes
            }
            if (file.kind == FoundKind.RCX_IMAGE) return addImage(file, bytes)
            if (bytes.size > JsonLimits.MAXIMUM_BYTES) {
                return problems.plusAssign(messages.tooLarge(file.name, JsonLimits.MAXIMUM_BYTES))
            }
            val reading = readText(file.name, bytes) as? TextReading.Read
            val text = reading?.text
            when {
                text == null -> {
                    problems += messages.notText(file.name)
                }

                file.kind == FoundKind.TEXT -> {
                    addText(file, text)
                }

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
            val hasWork = projects.any { it.submission is Submission.Usable }
            val programs = if (hasWork) emptyList() else listOfNotNull(ofPrograms())
            val usable = (projects + programs).ifEmpty { if (group.isPupils) copies else emptyList() }
            val isNone = usable.isEmpty() && (group.isPupils || problems.isNotEmpty() || notes.isEmpty())
            val reason = problems.firstOrNull() ?: notes.firstOrNull() ?: messages.nothingUsable()
            if (!isNone) return ReadFiles(usable, notes)
            return ReadFiles(listOf(candidate(Submission.Unusable(group.name, group.origin, reason))), emptyList())
        }

        private suspend fun addText(file: FoundFile, text: String) {
            if (isProject(text)) {
                when (val result = readProject(text, language)) {
                    is ProjectFileResult.Loaded -> addProject(file, result.project, group.name, file.name)
                    is ProjectFileResult.Rejected -> problems += "${file.name}: ${result.message}"
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
                is LinkResult.OfProject -> return addProject(file, result.project, name, origin, link)
                is LinkResult.OfWorld -> messages.onlyWorld()
                is LinkResult.OfCourse -> messages.onlyCourse()
                is LinkResult.Rejected -> result.message
            }
            projects += candidate(Submission.Unusable(name, originOf(origin), reason), link = link)
        }

        /** @param link from which [project] came; null if it is a file. */
        private fun addProject(file: FoundFile, project: Project, name: String, origin: String, link: String? = null) {
            val isAssignment = given.isAssignment(project)
            when {
                project.feedback != null -> notes += messages.isFeedback(origin)
                isAssignment && !group.isPupils -> notes += messages.isAssignment(origin)
                else -> (if (isAssignment) copies else projects) += candidate(file, project, name, origin, link)
            }
        }

        private fun candidate(
            file: FoundFile,
            project: Project,
            name: String,
            origin: String,
            link: String?,
        ): Candidate {
            val handIn = project.handIn
            val entered = handIn?.name.orEmpty().takeIf { it.isNotBlank() && group.key == null }
            val shown = entered ?: name
            val first = project.world.robots.first().name
            val robot = project.robots.firstOrNull { it.name == first }
            val submission = if (robot == null || robot.programs.isEmpty()) {
                Submission.Unusable(shown, originOf(origin), messages.noProgram(first))
            } else {
                val found = remarks.of(project) + remarks.of(robot.programs)
                Submission.Usable(shown, originOf(origin), robot, project, handIn, found)
            }
            return candidate(submission, file.modified ?: 0, link)
        }

        /** All Java files are one program; of files with the same name the newest counts. */
        private fun ofPrograms(): Candidate? {
            val newest = sources.groupBy { it.first.name }.values.map { same -> same.maxBy { it.first.modified ?: 0 } }
            val programs = programsOf(newest.map { (file, text) -> file.kind to SourceFile(file.name, text) })
            if (programs.isEmpty()) return null
            val modified = newest.maxOf { it.first.modified ?: 0 }
            val submission = if (programs.size > BrickProgram.MAX_PROGRAMS) {
                val reason = messages.tooManyPrograms(programs.size, BrickProgram.MAX_PROGRAMS)
                Submission.Unusable(group.name, group.origin, reason)
            } else {
                val robot = ProjectRobot(assignment.world.robots.first().name, programs)
                val unusual = changes.map(SubmissionRemark::ReadAllTheSame)
                Submission.Usable(group.name, group.origin, robot, remarks = remarks.of(programs) + unusual)
            }
            return candidate(submission, modified)
        }

        private fun programsOf(files: List<Pair<FoundKind, SourceFile>>): List<ProjectProgram> {
            val sources = files.groupBy({ it.first }, { it.second })
            val java = sources[FoundKind.JAVA].orEmpty()
            val alone = sources[FoundKind.ROBOLANG].orEmpty() + sources[FoundKind.LASM].orEmpty()
            val programs = alone.map { file ->
                ProgramSource.of(checkNotNull(ProgramLanguage.ofFile(file.name)), file.name, listOf(file))
            } + nqcProgramsOf(sources[FoundKind.NQC].orEmpty()) +
                listOfNotNull(java.firstOrNull()?.let { ProgramSource.Java(it.name, java) })
            return programs.mapNotNull { ProjectProgram.of(it) }
        }

        /** @param link from which it came; null for files. */
        private fun candidate(submission: Submission, modified: Long = 0, link: String? = null): Candidate {
            val place = group.key ?: if (group.isFolder) group.origin else ""
            // A folder that no platform has made may still hold what several pupils have handed in.
            val pupil = group.key ?: listOf(link.takeUnless { group.isFolder } ?: group.origin, keyOf(submission.name))
                .joinToString(" ")
            return Candidate(place, pupil, modified, submission)
        }

        private fun originOf(file: String) = if (group.isFolder) "${group.origin}/$file" else file
    }

    private fun isTooLong(text: String) = text.length > ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS ||
        text.count { it == '\n' } >= ProjectLimits.MAXIMUM_LINES

    private fun isProject(text: String): Boolean = text.trimStart().startsWith('{')
}
