package robotran.physics;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.collision.manifold.ClippingManifoldSolver;
import org.dyn4j.collision.manifold.ManifoldSolver;
import org.dyn4j.collision.narrowphase.Gjk;
import org.dyn4j.collision.narrowphase.NarrowphaseDetector;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Transform;

/**
 * Finds the contacts of all bodies. It works like the detection of dyn4j's {@code World} and finds the same contacts in
 * the same order, but only looks at what may have moved.
 */
final class ContactFinder {
    private final Settings settings;
    private final BoundsTree tree;
    private final NarrowphaseDetector detector = new Gjk();
    private final ManifoldSolver manifolds = new ClippingManifoldSolver();
    private final ContactMixer mixer = new ContactMixer();
    private final List<Leaf> newLeaves = new ArrayList<>();
    private final List<RigidBody> touchedBodies = new ArrayList<>();

    private boolean surroundingsAreOld = true;

    /** In the order in which they came near each other. */
    private List<FixturePair> pairs = new ArrayList<>();

    private List<FixturePair> spare = new ArrayList<>();

    ContactFinder(Settings settings, BoundsTree tree) {
        this.settings = settings;
        this.tree = tree;
    }

    /** Adds a fixture of a body, or looks at it as if it had been added now. */
    void add(Leaf leaf) {
        note(leaf);
        surroundingsAreOld = true;
    }

    private void note(Leaf leaf) {
        if (!leaf.isNew) {
            leaf.isNew = true;
            newLeaves.add(leaf);
        }
    }

    /** Finds the contacts, given all movable bodies in a constant order. */
    void find(List<RigidBody> movable) {
        for (int i = 0; i < movable.size(); i++) {
            RigidBody body = movable.get(i);
            if (surroundingsAreOld || body.isAtRest()) {
                body.surroundings.forget();
            }
        }
        surroundingsAreOld = false;
        for (int i = 0; i < movable.size(); i++) {
            follow(movable.get(i), movable);
        }
        for (int i = 0; i < newLeaves.size(); i++) {
            search(newLeaves.get(i));
        }
        for (int i = 0; i < touchedBodies.size(); i++) {
            touchedBodies.get(i).contacts.clear();
        }
        touchedBodies.clear();
        compare();
        for (int i = 0; i < newLeaves.size(); i++) {
            newLeaves.get(i).isNew = false;
        }
        newLeaves.clear();
    }

    /** Updates the rectangles of a body that may have moved. */
    private void follow(RigidBody body, List<RigidBody> movable) {
        if (body.isAtRest()) {
            body.hasMoved = false;
            return;
        }
        body.notePose();
        if (!body.hasMoved) {
            return;
        }
        for (int i = 0; i < body.leaves.size(); i++) {
            Leaf leaf = body.leaves.get(i);
            leaf.measure();
            if (!leaf.fits()) {
                tree.remove(leaf);
                leaf.fit();
                tree.insert(leaf);
                note(leaf);
                for (int j = 0; j < movable.size(); j++) {
                    if (movable.get(j) != body) {
                        movable.get(j).surroundings.note(leaf);
                    }
                }
            }
        }
    }

    /** Finds new pairs with a leaf whose rectangle has changed. */
    private void search(Leaf leaf) {
        if (!leaf.body.stays() && !leaf.body.surroundings.hasNewPair(leaf, tree)) {
            return;
        }
        // The order of new pairs is that of the tree.
        TreeNode node = tree.root();
        while (node != null) {
            boolean overlaps = node.overlaps(leaf);
            if (overlaps && node.left != null) {
                node = node.left;
                continue;
            }
            if (overlaps && isNewPair(leaf, (Leaf) node)) {
                pairs.add(new FixturePair(leaf, (Leaf) node));
            }
            node = BoundsTree.after(node);
        }
    }

    private static boolean isNewPair(Leaf leaf, Leaf other) {
        return leaf.body != other.body
            && (leaf.body.isDynamic() || other.body.isDynamic())
            && !leaf.isPairedWith(other);
    }

    private void compare() {
        List<FixturePair> all = pairs;
        List<FixturePair> kept = spare;
        for (int i = 0; i < all.size(); i++) {
            FixturePair pair = all.get(i);
            if (!pair.stays()) {
                if ((pair.first.isNew || pair.second.isNew) && !pair.first.overlaps(pair.second)) {
                    pair.remove();
                    continue;
                }
                compare(pair);
            }
            kept.add(pair);
        }
        all.clear();
        pairs = kept;
        spare = all;
    }

    private void compare(FixturePair pair) {
        boolean touches = !pair.isCertainlyApart() && touches(pair);
        pair.isApart = !touches;
        if (!touches) {
            pair.penetration.clear();
            pair.manifold.clear();
            if (pair.constraint.getContacts().isEmpty()) {
                return;
            }
        }
        // Also ends contacts that are no longer there.
        pair.constraint.update(pair.manifold, settings, mixer);
        if (touches) {
            touched(pair.first.body, pair);
            touched(pair.second.body, pair);
        }
    }

    private void touched(RigidBody body, FixturePair pair) {
        if (body.contacts.isEmpty()) {
            touchedBodies.add(body);
        }
        body.contacts.add(pair);
        // A body is woken before its contact is solved, so the solver finds all as if none had rested.
        body.setAtRest(false);
    }

    private boolean touches(FixturePair pair) {
        Convex first = pair.first.fixture.getShape();
        Convex second = pair.second.fixture.getShape();
        Transform pose1 = pair.first.body.getTransform();
        Transform pose2 = pair.second.body.getTransform();
        pair.penetration.clear();
        pair.manifold.clear();
        return detector.detect(first, pose1, second, pose2, pair.penetration)
            && pair.penetration.getDepth() != 0
            && manifolds.getManifold(pair.penetration, first, pose1, second, pose2, pair.manifold)
            && !pair.manifold.getPoints().isEmpty();
    }
}
