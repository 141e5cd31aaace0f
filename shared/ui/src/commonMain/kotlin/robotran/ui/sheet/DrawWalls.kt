package robotran.ui.sheet
import androidx.compose.ui.graphics.drawscope.DrawScope
import robotran.world.World
internal fun DrawScope.drawWalls(world: World, transform: SheetTransform) { }
