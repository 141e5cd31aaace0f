package robotran.assignments.collecting

import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.programsOf
import robotran.programs.support
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram

/**
 * The programs in the files of one pupil, by name, so that it does not matter how they were packed. What is there twice
 * is one. All Java files are one program, or one for each that has a `main`, or for each version of a class.
 */
internal fun programsOf(files: List<Pair<FoundFile, String>>): List<ProjectProgram> {
    val sorted = files.sortedBy { it.first.shownPath }.distinctBy { (file, text) -> file.language to text }
    val isAmbiguous = sorted.groupingBy { it.first.name }.eachCount()
    val named = sorted.map { (file, text) ->
        val name = if (isAmbiguous.getValue(file.name) > 1) file.shownPath else file.name
        file to SourceFile(name.takeLast(ProjectLimits.MAXIMUM_NAME_CHARACTERS), text)
    }
    val (classes, others) = named.partition { it.first.isNamedByContent }
    val sources = others.groupBy({ it.first.language }, { it.second })
    val all = sources.flatMap { (language, files) -> language?.let { programsOf(files, it) }.orEmpty() } +
        programsOfClasses(classes)
    return all.mapNotNull { ProjectProgram.of(it) }.sortedBy { it.name }
}

/** @property file the name under which it was handed in. */
private class ClassFile(val file: String, val folder: String, val source: SourceFile)

private fun programsOfClasses(files: List<Pair<FoundFile, SourceFile>>): List<Program> {
    val all = files.map { (found, source) ->
        ClassFile(source.name, found.path.dropLast(1).joinToString("/"), namedByContent(source.copy(name = found.name)))
    }
    return versionsOf(all).flatMap(::startingAnywhere).distinctBy { it.files }
}

/** Sets of [all] in which no two have the same class: one for each folder, and for each version in a folder. */
private fun versionsOf(all: List<ClassFile>): List<List<ClassFile>> {
    if (all.isEmpty()) return emptyList()
    val byClass = all.groupBy { it.source.name }.values
    if (byClass.all { it.size == 1 }) return listOf(all)
    val folders = all.groupBy { it.folder }
    if (folders.size > 1) return folders.values.flatMap(::versionsOf)
    return List(byClass.maxOf { it.size }) { version -> byClass.map { it.getOrElse(version) { _ -> it.last() } } }
}

/** A program for each file of [files] that has a `main`, or else one. */
private fun startingAnywhere(files: List<ClassFile>): List<Program> =
    files.filter { languageOf(it).support.files.canStart(it.source.text) }.ifEmpty { files.take(1) }.map { first ->
        Program(
            first.file,
            languageOf(first),
            listOf(first.source) + (files - first).map { it.source },
        )
    }

private fun languageOf(file: ClassFile) = ProgramLanguage.ofFileOrDefault(file.source.name)
