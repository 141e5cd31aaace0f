package robotran.cli.translate

import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.robolang.translate.KitFile

/**
 * [files] as a zip file: the same bytes for the same files, whenever and wherever it is made; a script can be run as it
 * is unpacked.
 */
internal fun zip(files: List<KitFile>): ByteArray =
    zipOf(files.map { ZipEntry(it.path, it.text.encodeToByteArray(), it.isExecutable) })
