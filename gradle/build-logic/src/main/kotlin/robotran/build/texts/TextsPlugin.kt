package robotran.build.texts

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** Gives a multiplatform module the `texts { }` block of [TextsExtension]. */
class TextsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.extensions.create("texts", TextsExtension::class.java, project)
    }
}

/** Which texts of the tree a module has as Kotlin constants: maps from path to text. */
open class TextsExtension(private val project: Project) {
    /**
     * Gives [sourceSet] the constant [qualifiedName] with the files of [folder], seen from the root, whose paths in it
     * match [pattern].
     */
    fun constant(sourceSet: String, qualifiedName: String, folder: String, pattern: String) =
        generate(sourceSet, qualifiedName, folder, pattern, fence = null)

    /**
     * Gives [sourceSet] the constant [qualifiedName] with the blocks marked [fence] of the Markdown files, by file and
     * line.
     */
    fun blocks(sourceSet: String, qualifiedName: String, folder: String, pattern: String, fence: String) =
        generate(sourceSet, qualifiedName, folder, pattern, fence)

    private fun generate(sourceSet: String, qualifiedName: String, folder: String, pattern: String, fence: String?) {
        val name = qualifiedName.substringAfterLast('.')
        val task =
            project.tasks.register("generate" + name.replaceFirstChar(Char::uppercase), GenerateTexts::class.java) {
                it.texts.set(
                    project.fileTree(project.rootProject.layout.projectDirectory.dir(folder)) { tree ->
                        tree.include(pattern)
                    },
                )
                it.qualifiedName.set(qualifiedName)
                it.fence.set(fence)
                it.outputFolder.set(project.layout.buildDirectory.dir("generated/texts/$name"))
            }
        project.extensions.getByType(
            KotlinMultiplatformExtension::class.java,
        ).sourceSets.getByName(sourceSet).kotlin.srcDir(task)
    }
}
