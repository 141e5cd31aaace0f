package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.collision.CollisionItem;
import org.dyn4j.collision.broadphase.BroadphaseDetector;
import org.dyn4j.collision.broadphase.BroadphaseDetectorDecoratorAdapter;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;

/** Updates the bounds only of what may have moved. dyn4j computes all of them before each detection. */
final class MovingBroadphase extends BroadphaseDetectorDecoratorAdapter<CollisionItem<Body, BodyFixture>> {
    private final List<CollisionItem<Body, BodyFixture>> items = new ArrayList<>();

    MovingBroadphase(BroadphaseDetector<CollisionItem<Body, BodyFixture>> detector) {
        super(detector);
    }

    @Override
    public void add(CollisionItem<Body, BodyFixture> item) {
        super.add(item);
        items.add(item);
    }

    @Override
    public boolean remove(CollisionItem<Body, BodyFixture> item) {
        items.remove(item);
        return super.remove(item);
    }

    @Override
    public void clear() {
        items.clear();
        super.clear();
    }

    @Override
    public void update() {
        // An index instead of an iterator, which would be garbage in each step.
        for (int i = 0; i < items.size(); i++) {
            CollisionItem<Body, BodyFixture> item = items.get(i);
            if (!RestingBodies.stays(item.getBody())) {
                update(item);
            }
        }
    }
}
