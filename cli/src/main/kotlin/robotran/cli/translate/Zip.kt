package robotran.cli.translate

import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.robolang.translate.KitFile

/**
 * [files] as a zip file. The output is reproducible: the same files give the same bytes. Scripts keep their executable
 * bit.
 */
internal fun zip(files: List<KitFile>): ByteArray =
    zipOf(files.map { ZipEntry(it.path, it.text.encodeToByteArray(), it.isExecutable) })
