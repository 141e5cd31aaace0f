package robotran.documents

import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject

/** [project] as the bytes of a `.robotran` file; null if it exceeds the limits for reading. */
fun projectFile(project: Project): ByteArray? =
    writeProject(project).takeIf { readProject(it, Language.ENGLISH) is ProjectFileResult.Success }?.encodeToByteArray()

/** The result of checking a project's file before writing. */
enum class SavingCheck {
    /** The file is unchanged since the last save, or missing: it can be written. */
    FREE,

    /** Another program has changed the file, and writing would discard the change. */
    CHANGED,
}

/**
 * Whether [file] can be written without discarding the changes of another program.
 *
 * @param now its current content; null if it is missing.
 * @param toWrite the new content; if it equals the current one, nothing is lost.
 */
fun checkBeforeSaving(file: SaveTarget, now: ByteArray?, toWrite: ByteArray): SavingCheck =
    if (now == null || FileStamp.of(now) == file.stamp || now.contentEquals(toWrite)) {
        SavingCheck.FREE
    } else {
        SavingCheck.CHANGED
    }
