package robotran.lejoslinker

import robotran.lejoslinker.config.ImageLimits
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.link.ClassCollector
import robotran.lejoslinker.link.ClassFiles
import robotran.lejoslinker.link.CodePlace
import robotran.lejoslinker.link.CodeRewriter
import robotran.lejoslinker.link.ConstantTable
import robotran.lejoslinker.link.ErrorList
import robotran.lejoslinker.link.FieldLayout
import robotran.lejoslinker.link.Hierarchy
import robotran.lejoslinker.link.ImageLayout
import robotran.lejoslinker.link.ImageWriter
import robotran.lejoslinker.link.LinkedTables
import robotran.lejoslinker.link.MethodSelector
import robotran.lejoslinker.link.SignatureTable
import robotran.lejoslinker.link.UsedParts
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.classMissing
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.config.BrickRoom

/** Links one image, in steps; a step needs the tables of those before it. */
internal class ImageLinker(
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    entryClasses: List<String>,
    private val options: ImageOptions,
    private val messages: ImageMessages,
) {
    private val errors = ErrorList()
    private val files = ClassFiles(program, library, errors, messages)
    private val entryClasses = entryClasses.ifEmpty { listOfNotNull(files.firstWithMain) }

    fun link(): ImageResult {
        if (!errors.isEmpty) return refused()
        val place = CodePlace(entryClasses.firstOrNull() ?: files.first.orEmpty())
        when {
            entryClasses.isEmpty() -> errors.add(place, messages.tinyVm.noMainMethod())

            entryClasses.size > ImageLimits.ENTRY_CLASSES -> {
                errors.add(place, messages.tooManyPrograms(entryClasses.size, ImageLimits.ENTRY_CLASSES))
            }
        }
        if (!errors.isEmpty) return refused()
        val used = if (options.isTrimmed) UsedParts(files, entryClasses) else null
        if (!errors.isEmpty) return refused()
        val collector = ClassCollector(files, errors, messages)
        val classes = collector.collect(entryClasses, used)
        if (!errors.isEmpty) return refused()
        val hierarchy = Hierarchy(classes)
        hierarchy.connect(errors, messages)
        if (!errors.isEmpty) return refused()
        val signatures = SignatureTable()
        MethodSelector(classes, signatures, errors, messages).select(options.keepsAllMethods, used)
        FieldLayout(classes, errors, messages).place(used)
        val constants = ConstantTable(classes, errors, messages, used)
        if (!errors.isEmpty) return refused()
        rewriteCode(LinkedTables(classes, hierarchy, constants, errors, messages))
        if (errors.isEmpty) {
            collector.missing.forEach { (name, place) ->
                errors.add(place, messages.classMissing(name))
            }
        }
        if (!errors.isEmpty) return refused()
        val entries = entryClasses.distinct().map { checkNotNull(hierarchy.classNamed(it)).number }
        return finish(ImageLayout(classes, signatures, constants, entries), place)
    }

    private fun rewriteCode(tables: LinkedTables) {
        for (method in tables.classes.flatMap { it.methods }) {
            val body = method.body ?: continue
            method.code = CodeRewriter(tables, method, body).rewrite()
            for (handler in body.handlers) {
                val type = handler.catchType ?: continue
                if (tables.hierarchy.classNamed(type) == null) {
                    errors.add(method.place, messages.classMissing(type))
                }
            }
        }
    }

    private fun finish(layout: ImageLayout, place: CodePlace): ImageResult {
        val room = BrickRoom.of(options.version)
        if (layout.size > minOf(room.maxImageBytes, ImageLimits.IMAGE_OFFSET)) {
            errors.add(place, messages.imageTooLarge(layout.size, room.maxImageBytes))
            return refused()
        }
        val image = LejosImage(ImageWriter(layout, options.byteOrder).write(), layout.contents())
        val left = image.bytesForObjects(options.version)
        val warnings = if (left < BrickRoom.FEW_BYTES) listOf(messages.littleMemory(left)) else emptyList()
        return ImageResult.Success(image, warnings)
    }

    private fun refused() = ImageResult.Failure(errors.withFiles(files::sourceFileOf))
}
