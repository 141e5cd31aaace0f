package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project

/** Adds the `brickPrograms { }` block of [BrickProgramsExtension] to a multiplatform module. */
class BrickProgramsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val library = resolvable(project, LIBRARY)
        project.dependencies.add(
            library.name,
            project.dependencies.project(mapOf("path" to ":shared:lejos-library", "configuration" to BRICK_CLASSES)),
        )
        project.extensions.create("brickPrograms", BrickProgramsExtension::class.java, project)
    }

    internal companion object {
        const val LIBRARY = "brickLibrary"
    }
}

/** The leJOS programs of the tree that a module embeds as class files. */
open class BrickProgramsExtension(private val project: Project) {
    /**
     * Generates the constant [qualifiedName] in [sourceSet] with the class files, in Base64, of the programs in
     * [folder], relative to the root. Each source is a separate program; the key is the path of the source, a slash,
     * and the class file name. Programs with expected errors are left out.
     */
    fun constant(sourceSet: String, qualifiedName: String, folder: String) {
        val name = qualifiedName.substringAfterLast('.')
        val root = project.rootProject.layout.projectDirectory
        val sources = project.provider { project.fileTree(root.dir(folder)) { it.include("**/*.java") } }
        val compile =
            compileForBrick(project, "compile" + name.replaceFirstChar(Char::uppercase), name, sources) { task ->
                task.library.from(project.configurations.getByName(BrickProgramsPlugin.LIBRARY))
                task.eachAlone.set(true)
            }
        generateClassFiles(project, compile, qualifiedName, sourceSet)
    }
}
