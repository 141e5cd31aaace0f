package robotran.physics;

import org.dyn4j.collision.narrowphase.Gjk;
import org.dyn4j.collision.narrowphase.Raycast;
import org.dyn4j.collision.narrowphase.RaycastDetector;
import org.dyn4j.geometry.Ray;
import org.dyn4j.geometry.Vector2;

/** Finds the first fixture in the way of a ray, like dyn4j's {@code World}. */
final class RayCaster {
    private final BoundsTree tree;
    private final RaycastDetector detector = new Gjk();
    private final Raycast hit = new Raycast();
    private final Beam beam = new Beam();

    /** What the last ray has met; null if nothing. */
    private Leaf met;

    private double metX;
    private double metY;

    RayCaster(BoundsTree tree) {
        this.tree = tree;
    }

    /**
     * The free distance along {@code way} from {@code from}; {@code length}, that of {@code way}, if nothing is in the
     * way. Ignores the fixtures of {@code own}, and any that contains {@code from}.
     *
     * @param boundsAreOld whether a body has been moved after the last detection
     */
    double freeDistance(RigidBody own, Vector2 from, Vector2 way, double length, boolean boundsAreOld) {
        Ray ray = new Ray(from, way);
        beam.set(from, ray.getDirectionVector(), length);
        double free = length;
        met = null;
        TreeNode node = tree.root();
        while (node != null) {
            // dyn4j takes a length of 0 for no limit.
            boolean meets = beam.meets(node, boundsAreOld || free == 0 ? length : free);
            if (meets && node.left != null) {
                node = node.left;
                continue;
            }
            if (meets) {
                Leaf leaf = (Leaf) node;
                if (leaf.body != own
                    && detector.raycast(ray, free, leaf.fixture.getShape(), leaf.body.getTransform(), hit)) {
                    free = hit.getDistance();
                    met = leaf;
                    metX = hit.getPoint().x;
                    metY = hit.getPoint().y;
                }
            }
            node = BoundsTree.after(node);
        }
        return free;
    }

    /** What the last ray has met; null if nothing. */
    Leaf met() {
        return met;
    }

    /** The direction in which the surface looks that the last ray has met. */
    Vector2 metNormal() {
        return met.normalAt(metX, metY);
    }

    /** A ray and its bounds. */
    private static final class Beam extends TreeNode {
        private double x;
        private double y;
        private double inverseX;
        private double inverseY;

        void set(Vector2 from, Vector2 direction, double length) {
            x = from.x;
            y = from.y;
            inverseX = 1 / direction.x;
            inverseY = 1 / direction.y;
            double endX = x + direction.x * length;
            double endY = y + direction.y * length;
            minX = Math.min(x, endX);
            minY = Math.min(y, endY);
            maxX = Math.max(x, endX);
            maxY = Math.max(y, endY);
        }

        /** Whether it meets a rectangle before {@code end}. */
        boolean meets(TreeNode node, double end) {
            if (!overlaps(node)) {
                return false;
            }
            double left = (node.minX - x) * inverseX;
            double right = (node.maxX - x) * inverseX;
            double bottom = (node.minY - y) * inverseY;
            double top = (node.maxY - y) * inverseY;
            double near = Math.max(Math.min(left, right), Math.min(bottom, top));
            double far = Math.min(Math.max(left, right), Math.max(bottom, top));
            if (far < 0 || near > end) {
                return false;
            }
            // Not a number for a ray along an edge. It misses a leaf then, but not what is below an inner node.
            return node.left == null ? far >= near : !(far < near);
        }
    }
}
