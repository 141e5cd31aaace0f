package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration

/** Adds the `brickPrograms { }` block of [BrickProgramsExtension] to a multiplatform module. */
class BrickProgramsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.extensions.create("brickPrograms", BrickProgramsExtension::class.java, project)
    }
}

/** The leJOS programs of the tree that a module embeds as class files. */
open class BrickProgramsExtension(private val project: Project) {
    /**
     * Generates the constant [qualifiedName] in [sourceSet] with the class files, in Base64, of the programs in
     * [folder], relative to the root, for an RCX. Each source is a separate program; the key is the path of the source,
     * a slash, and the class file name. Programs with expected errors are left out.
     */
    fun constant(sourceSet: String, qualifiedName: String, folder: String) =
        generate(sourceSet, qualifiedName, folder, BrickTarget.LEJOS_RCX)

    /** The same for an NXT with leJOS NXJ. */
    fun nxjConstant(sourceSet: String, qualifiedName: String, folder: String) =
        generate(sourceSet, qualifiedName, folder, BrickTarget.LEJOS_NXJ)

    private fun generate(sourceSet: String, qualifiedName: String, folder: String, target: BrickTarget) {
        val name = qualifiedName.substringAfterLast('.')
        val root = project.rootProject.layout.projectDirectory
        val sources = project.provider { project.fileTree(root.dir(folder)) { it.include("**/*.java") } }
        val taskName = "compile" + name.replaceFirstChar(Char::uppercase)
        val compile = compileForBrick(project, taskName, name, sources, target) { task ->
            task.library.from(libraryFor(target))
            task.eachAlone.set(true)
        }
        generateClassFiles(project, compile, qualifiedName, sourceSet)
    }

    private fun libraryFor(target: BrickTarget): Configuration {
        val name = if (target == BrickTarget.LEJOS_RCX) "brickLibrary" else "nxjBrickLibrary"
        return project.configurations.findByName(name) ?: resolvable(project, name).also {
            val module = mapOf("path" to target.library, "configuration" to BRICK_CLASSES)
            project.dependencies.add(name, project.dependencies.project(module))
        }
    }
}
