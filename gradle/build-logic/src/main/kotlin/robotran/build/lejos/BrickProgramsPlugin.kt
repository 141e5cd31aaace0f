package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project

/** Gives a multiplatform module the `brickPrograms { }` block of [BrickProgramsExtension]. */
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

/** Which leJOS programs of the tree a module has as class files. */
open class BrickProgramsExtension(private val project: Project) {
    /**
     * Gives [sourceSet] the constant [qualifiedName] with the class files, in Base64, of the programs in [folder], seen
     * from the root: each source is a program of its own, and the path is the source's, a slash, and the class file's.
     * Programs that tell mistakes are left out.
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
