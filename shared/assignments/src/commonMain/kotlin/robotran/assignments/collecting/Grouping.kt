package robotran.assignments.collecting

import robotran.documents.FileKind

/**
 * Files that belong together.
 *
 * @property key the same for all files of one pupil, if a learning platform has told; null otherwise.
 * @property name of the pupil, as far as folders and files tell.
 * @property origin the folder or file, as shown.
 * @property isFolder whether it is a pupil's folder rather than one file.
 * @property isPupils whether the files lie where only this pupil's do.
 */
internal class FileGroup(
    val key: String?,
    val name: String,
    val origin: String,
    val files: List<FoundFile>,
    val isFolder: Boolean,
    val isPupils: Boolean = isFolder,
) {
    /** The same with the [files] that [belongs] takes alone; null if there are none. */
    fun only(belongs: (FoundFile) -> Boolean): FileGroup? =
        files.filter(belongs).ifEmpty { null }?.let { FileGroup(key, name, origin, it, isFolder, isPupils) }
}

/**
 * Sorts [files] by pupils: by the names that learning platforms make, or else by folders, or else file by file. In a
 * course, all files together tell which folders are pupils'; what is one program is told for each assignment alone.
 *
 * @param isNoHandIn whether a file is something else, such as the assignment, which may lie beside a class's folder.
 */
internal fun groupsOf(files: List<FoundFile>, isNoHandIn: (FoundFile) -> Boolean): List<FileGroup> {
    val named = files.map { file -> file to platformPlace(file) }
    val byPlatform = named.filter { it.second != null }.groupBy({ checkNotNull(it.second).name.key }, { it })
        .map { (key, found) ->
            val place = checkNotNull(found.first().second)
            FileGroup(
                key,
                place.name.pupil,
                place.origin,
                found.map { (file, place) ->
                    file.at(checkNotNull(place).inner)
                },
                true,
            )
        }
    return byPlatform + FolderGrouping(isNoHandIn).groups(named.filter { it.second == null }.map { it.first }, 0, "")
}

private class PlatformPlace(val name: PlatformName, val origin: String, val inner: List<String>)

private fun platformPlace(file: FoundFile): PlatformPlace? {
    file.path.forEachIndexed { index, part ->
        val name = PlatformName.of(part) ?: return@forEachIndexed
        val inner = listOf(name.rest).filter { it.isNotEmpty() } + file.path.drop(index + 1)
        return PlatformPlace(name, file.path.take(index + 1).joinToString("/"), inner.ifEmpty { listOf(file.name) })
    }
    return null
}

private class FolderGrouping(private val isNoHandIn: (FoundFile) -> Boolean) {
    /**
     * The groups of [files], which all lie in the same folder at [depth].
     *
     * @param prefix names the class if there are several; empty otherwise.
     */
    fun groups(files: List<FoundFile>, depth: Int, prefix: String): List<FileGroup> {
        val direct = files.filter { it.path.size == depth + 1 && !it.isEmptyFolder }
        val folders = files.filter { it.path.size > depth + 1 }.groupBy { it.path[depth] }
        val only = folders.values.singleOrNull()?.takeUnless { files -> files.all { it.isEmptyFolderAt(depth + 1) } }
        if (only != null && (direct.all(isNoHandIn) || isClass(only, depth + 1))) {
            return directGroups(direct, depth, prefix, isOnly = false) + groups(only, depth + 1, prefix)
        }
        val isAlone = folders.isEmpty() && depth >= 2
        if (isAlone && direct.size > 1 && isOneForEachTask(direct)) return listOf(ofOnePupil(direct, depth, prefix))
        val classes = folders.filterValues { holdsPupils(it, depth + 1) }.keys
        return directGroups(direct, depth, prefix, isAlone && direct.size == 1) + folders.flatMap { (name, inside) ->
            if (name in classes) {
                groups(inside, depth + 1, if (classes.size == 1) prefix else "$prefix$name/")
            } else {
                listOf(ofOnePupil(inside, depth + 1, prefix))
            }
        }
    }

    /** What is in a pupil's folder, whose name stands before [depth]. */
    private fun ofOnePupil(inside: List<FoundFile>, depth: Int, prefix: String): FileGroup {
        val folders = inside.first().path.take(depth)
        val files = inside.map { it.at(it.path.drop(depth)) }
        return FileGroup(null, prefix + folders.last(), folders.joinToString("/"), files, true)
    }

    private fun directGroups(direct: List<FoundFile>, depth: Int, prefix: String, isOnly: Boolean): List<FileGroup> =
        direct.groupBy { it.task }.values.flatMap { groupsOfTask(it, depth, prefix, isOnly) }

    private fun groupsOfTask(direct: List<FoundFile>, depth: Int, prefix: String, isOnly: Boolean): List<FileGroup> {
        val java = direct.filter { it.isNamedByContent }
        val compiled = if (java.isEmpty()) emptyList() else direct.filter { it.isClassFile }
        val isOneProgram = java.size > 1 && java.count(::startsHere) < 2
        val includes = IncludedFiles(direct)
        val parts = includes.included + compiled + if (isOneProgram) java else emptyList()
        val single = direct.filterNot { it in parts }.map { file ->
            val name = if (isOnly) file.path[depth - 1] else stemOf(file.name)
            val files = (listOf(file) + includes.includedBy(file) + classesOf(file, compiled)).map {
                it.at(listOf(it.name))
            }
            FileGroup(null, prefix + name, file.shownPath, files, false, isOnly)
        }
        if (!isOneProgram) return single
        val main = java.firstOrNull(::startsHere) ?: java.first()
        val name = main.path.getOrNull(depth - 1) ?: stemOf(main.name)
        val origin = main.path.dropLast(1).ifEmpty { main.path }.joinToString("/")
        return single + FileGroup(null, prefix + name, origin, (java + compiled).map { it.at(listOf(it.name)) }, true)
    }

    /** Those of [compiled] that the compiler has made of [source]. */
    private fun classesOf(source: FoundFile, compiled: List<FoundFile>): List<FoundFile> =
        if (!source.isNamedByContent) {
            emptyList()
        } else {
            compiled.filter { stemOf(it.name).substringBefore('$') == stemOf(source.name) }
        }

    /** Whether a folder holds the folders of pupils, rather than the files of one. */
    private fun holdsPupils(files: List<FoundFile>, depth: Int): Boolean {
        val useful = files.filter { it.content !is FoundContent.Ignored }
        val folders = useful.filter { it.path.size > depth + 1 }.groupBy { it.path[depth] }
        if (useful.any { it.path.size == depth + 1 }) return false
        if (folders.size == 1) return holdsPupils(useful, depth + 1)
        return folders.size > 1 && (useful.any { !it.isNamedByContent } || most(useful.filter(::startsHere)) > 1)
    }

    /** Whether the only folder beside loose files holds the projects of several pupils, rather than the work of one. */
    private fun isClass(files: List<FoundFile>, depth: Int): Boolean {
        val works = files.filter { it.path.size == depth + 1 && it.content !is FoundContent.Ignored }
        return most(works) >= MINIMUM_WORKS_OF_CLASS &&
            works.any { it.name.endsWith(FileKind.PROJECT.extension, ignoreCase = true) }
    }

    /** Whether it is the folder at [depth] itself, with nothing in it. */
    private fun FoundFile.isEmptyFolderAt(depth: Int): Boolean = isEmptyFolder && path.size == depth + 1

    private fun isOneForEachTask(files: List<FoundFile>): Boolean = files.all { it.task != null } && most(files) == 1

    /** How many of [files] there are for the assignment that has the most of them. */
    private fun most(files: List<FoundFile>): Int = files.groupBy { it.task }.values.maxOfOrNull { it.size } ?: 0

    private fun startsHere(file: FoundFile): Boolean = file.isNamedByContent && file.canStart

    private companion object {
        /** One pupil may leave two, such as a program and a project. */
        const val MINIMUM_WORKS_OF_CLASS = 3
    }
}
