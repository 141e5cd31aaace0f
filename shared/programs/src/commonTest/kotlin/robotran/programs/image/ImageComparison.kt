package robotran.programs.image

import robotran.language.Language
import robotran.lejoslinker.ImageResult
import robotran.lejoslinker.LejosImage
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.linkLejosImage
import robotran.lejoslinker.messages.ImageMessages
import robotran.programs.CallRecorder
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.program.RcxProgram
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.TinyVmMessages

/** Runs class files, and what an image holds that was made of them. */
internal class ImageComparison(private val library: Map<String, ByteArray>) {
    /** Programs that were compared so far. */
    var compared = 0
        private set

    /**
     * How a run of the image of [program] differs from one of its class files, null if it does not. A program that has no
     * image, or is refused by the virtual machine, is not compared.
     *
     * @param original the bytes of the image; null for those of the linker.
     */
    fun differenceOf(
        program: Map<String, ByteArray>,
        mainClass: String,
        original: ByteArray? = null,
        happen: (RcxBrick, Long) -> Unit,
    ): String? {
        val result =
            linkLejosImage(
                program,
                library,
                listOf(mainClass),
                ImageOptions(isTrimmed = original == null),
                messages = ImageMessages.of(Language.ENGLISH),
            )
        val image = (result as? ImageResult.Success)?.image ?: return null
        val ofClassFiles =
            (link(program, library, mainClass, image.layout) as? TinyVmResult.Success)?.program ?: return null
        val ofImage = when (val rebuilt = rebuilt(image, original ?: image.bytes, program)) {
            is TinyVmResult.Success -> rebuilt.program
            is TinyVmResult.Failure -> return "the image is refused: ${rebuilt.refusal}"
        }
        compared++
        return differenceOf(ofClassFiles, ofImage, happen)
    }

    private fun rebuilt(image: LejosImage, bytes: ByteArray, program: Map<String, ByteArray>): TinyVmResult {
        val names = ImageNames(image.contents, library + program)
        val read = BrickImage(bytes)
        val rebuilt = ImageRebuilder(read, names).rebuild()
        val own = image.contents.classes.indices.filter { image.contents.classes[it].name in program }
            .map(names::classNamed).toSet()
        return link(
            rebuilt.filterKeys { it in own },
            rebuilt.filterKeys { it !in own },
            names.classNamed(read.entryClasses.single()),
            names.renamed(image.layout),
        )
    }

    private fun link(
        program: Map<String, ByteArray>,
        library: Map<String, ByteArray>,
        mainClass: String,
        layout: BrickLayout,
    ) = linkTinyVm(
        mainClass,
        program,
        library,
        mainClass,
        TinyVmMode.BRICK,
        speed = TinyVmSpeed.BRICK,
        layout = layout,
        messages = TinyVmMessages.of(Language.ENGLISH),
    )

    private fun differenceOf(classFiles: RcxProgram, image: RcxProgram, happen: (RcxBrick, Long) -> Unit): String? {
        val (wanted, made) = listOf(classFiles, image).map { program ->
            CallRecorder(program, happen).also { it.run(MILLISECONDS) }
        }
        val same = wanted.calls.zip(made.calls).takeWhile { (one, other) -> one == other }.size
        return when {
            same < wanted.calls.size || same < made.calls.size -> {
                "after $same calls ${made.calls.drop(same).take(2)} instead of ${wanted.calls.drop(same).take(2)}"
            }

            wanted.failures != made.failures -> "it fails with ${made.failures} instead of ${wanted.failures}"
            wanted.isOver != made.isOver -> "it is over: ${made.isOver} instead of ${wanted.isOver}"
            else -> null
        }
    }

    private companion object {
        const val MILLISECONDS = 10_000L
    }
}
