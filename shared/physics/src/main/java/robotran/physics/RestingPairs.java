package robotran.physics;

import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.world.PhysicsBodyBroadphaseCollisionDataFilter;
import org.dyn4j.world.World;

/** Saves the detection of contacts between bodies that do not move: none begins, and none exists where one rests. */
final class RestingPairs extends PhysicsBodyBroadphaseCollisionDataFilter<Body> {
    RestingPairs(World<Body> world) {
        super(world);
    }

    @Override
    public boolean isAllowed(Body body1, BodyFixture fixture1, Body body2, BodyFixture fixture2) {
        return !(RestingBodies.stays(body1) && RestingBodies.stays(body2))
            && super.isAllowed(body1, fixture1, body2, fixture2);
    }
}
