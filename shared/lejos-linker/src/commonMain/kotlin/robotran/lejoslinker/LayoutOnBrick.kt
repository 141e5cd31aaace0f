package robotran.lejoslinker

import robotran.lejoslinker.config.BrickRoom
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.config.LejosVersion

/** Where and what this image is on a brick with leJOS [version], for a run of the same program on the virtual machine. */
fun LejosImage.layoutOnBrick(version: LejosVersion): BrickLayout = BrickLayout(
    imageBytes = bytes.size,
    memoryBytes = BrickRoom.of(version).bytes,
    classNumbers = contents.classes.withIndex().associate { it.value.name to it.index },
    signatureNumbers = contents.signatures.withIndex().associate { it.value to it.index },
)
