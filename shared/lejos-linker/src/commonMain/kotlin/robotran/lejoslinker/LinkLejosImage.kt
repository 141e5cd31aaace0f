package robotran.lejoslinker

import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.messages.ImageMessages

/**
 * Links class files to the image that leJOS's firmware runs, byte for byte as leJOS's own linker does unless
 * [ImageOptions.isTrimmed]. Whatever the
 * firmware cannot run is refused, even where leJOS's linker does not look. The class files may contain arbitrary bytes,
 * but it is not checked that their code is sound: `linkTinyVm` does that.
 *
 * @param program the program's class files, under arbitrary names.
 * @param library the leJOS class files by internal name, such as `java/lang/Object`.
 * @param entryClasses internal names of the classes that can be started, in the order in which the Prgm button of a
 * brick goes through them; if empty, the first class of the program with a main method.
 */
fun linkLejosImage(
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    entryClasses: List<String>,
    options: ImageOptions = ImageOptions(),
    messages: ImageMessages,
): ImageResult = ImageLinker(program, library, entryClasses, options, messages).link()
