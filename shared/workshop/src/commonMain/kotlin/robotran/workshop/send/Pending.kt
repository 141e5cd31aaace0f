package robotran.workshop.send

import robotran.workshop.platform.Platform
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.state.PupilProgram

internal class ProgramImageBuilder(platform: Platform, preferences: Preferences, current: CurrentProject) :
    ImageBuilder {
    override suspend fun build(program: PupilProgram): ImageResult = TODO()
}
