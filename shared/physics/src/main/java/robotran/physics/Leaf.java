package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.geometry.AABB;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;

/**
 * A fixture in the {@link BoundsTree}. Its rectangle is larger than the fixture, so that it stays the same for a while
 * when the fixture moves.
 */
final class Leaf extends TreeNode {
    /** The same as in dyn4j, so that the same pairs are found in the same order. */
    private static final double MARGIN = 0.1;

    private static final double MAX_PERIMETER_RATIO = 2;

    final RigidBody body;
    final BodyFixture fixture;

    /** Index of the fixture on its body. */
    final int number;

    /** All pairs with this fixture. */
    final List<FixturePair> pairs = new ArrayList<>();

    /** Whether the rectangle has changed since the last detection. */
    boolean isNew;

    private final Convex shape;

    /** Null if the shape is no polygon. */
    private final Vector2[] corners;

    private final AABB bounds = new AABB(0, 0, 0, 0);

    /** The bounds of the fixture itself. */
    private double left0;

    private double bottom0;
    private double right0;
    private double top0;

    Leaf(RigidBody body, BodyFixture fixture) {
        this.body = body;
        this.fixture = fixture;
        number = body.leaves.size();
        shape = fixture.getShape();
        corners = shape instanceof Polygon ? ((Polygon) shape).getVertices() : null;
        measure();
        fit();
    }

    boolean isPairedWith(Leaf other) {
        for (int i = 0; i < pairs.size(); i++) {
            FixturePair pair = pairs.get(i);
            if (pair.first == other || pair.second == other) {
                return true;
            }
        }
        return false;
    }

    /** Makes the rectangle fit the measured bounds. */
    void fit() {
        minX = left0 - MARGIN;
        minY = bottom0 - MARGIN;
        maxX = right0 + MARGIN;
        maxY = top0 + MARGIN;
    }

    /** Whether the rectangle contains the measured bounds and is not much larger. */
    boolean fits() {
        if (minX > left0 || maxX < right0 || minY > bottom0 || maxY < top0) {
            return false;
        }
        double wanted = perimeter(left0 - MARGIN, bottom0 - MARGIN, right0 + MARGIN, top0 + MARGIN);
        return perimeter() / wanted <= MAX_PERIMETER_RATIO;
    }

    /** Whether there is a gap of at least {@code distance} between the measured bounds of both. */
    boolean isFarther(Leaf other, double distance) {
        return left0 - other.right0 > distance
            || other.left0 - right0 > distance
            || bottom0 - other.top0 > distance
            || other.bottom0 - top0 > distance;
    }

    boolean isRound() {
        return corners == null;
    }

    /** The direction in which the surface looks at a point of it: away from the middle, or across the nearest edge. */
    Vector2 normalAt(double x, double y) {
        Transform pose = body.getTransform();
        if (corners == null) {
            Vector2 outwards = pose.getTransformed(shape.getCenter()).to(new Vector2(x, y));
            outwards.normalize();
            return outwards;
        }
        Vector2 place = pose.getInverseTransformed(new Vector2(x, y));
        double nearest = Double.POSITIVE_INFINITY;
        int edge = 0;
        for (int i = 0; i < corners.length; i++) {
            double distance = squaredDistance(place, corners[i], corners[(i + 1) % corners.length]);
            if (distance < nearest) {
                nearest = distance;
                edge = i;
            }
        }
        return pose.getTransformedR(((Polygon) shape).getNormals()[edge]);
    }

    private static double squaredDistance(Vector2 place, Vector2 from, Vector2 to) {
        double alongX = to.x - from.x;
        double alongY = to.y - from.y;
        double x = place.x - from.x;
        double y = place.y - from.y;
        double part = (x * alongX + y * alongY) / (alongX * alongX + alongY * alongY);
        double part01 = part < 0 ? 0 : part > 1 ? 1 : part;
        double awayX = x - part01 * alongX;
        double awayY = y - part01 * alongY;
        return awayX * awayX + awayY * awayY;
    }

    /** Measures the bounds of the fixture at the current pose of its body. */
    void measure() {
        Transform pose = body.getTransform();
        if (corners == null) {
            shape.computeAABB(pose, bounds);
            left0 = bounds.getMinX();
            bottom0 = bounds.getMinY();
            right0 = bounds.getMaxX();
            top0 = bounds.getMaxY();
        } else {
            measureCorners(pose.getCost(), pose.getSint(), pose.getTranslationX(), pose.getTranslationY());
        }
    }

    private void measureCorners(double cosine, double sine, double x0, double y0) {
        left0 = bottom0 = Double.POSITIVE_INFINITY;
        right0 = top0 = Double.NEGATIVE_INFINITY;
        for (Vector2 corner : corners) {
            double x = cosine * corner.x - sine * corner.y + x0;
            double y = sine * corner.x + cosine * corner.y + y0;
            left0 = lower(left0, x);
            right0 = higher(right0, x);
            bottom0 = lower(bottom0, y);
            top0 = higher(top0, y);
        }
    }
}
