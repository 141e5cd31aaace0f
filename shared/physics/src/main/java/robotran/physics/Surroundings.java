package robotran.physics;

import java.util.ArrayList;
import java.util.List;

/**
 * A rectangle around a moving body and the leaves of other bodies in it. While the body moves within the rectangle,
 * only those can come near it, which saves most searches of the tree.
 */
final class Surroundings extends TreeNode {
    /** A body moves some tenths of it in a step. */
    private static final double MARGIN = 1.5;

    private final RigidBody body;
    private final List<Leaf> others = new ArrayList<>();
    private boolean isKnown;

    Surroundings(RigidBody body) {
        this.body = body;
    }

    void forget() {
        isKnown = false;
    }

    /** Call for each leaf of another body whose rectangle has changed. */
    void note(Leaf leaf) {
        if (isKnown && overlaps(leaf) && !others.contains(leaf)) {
            others.add(leaf);
        }
    }

    /** Whether a leaf of the body, which is in the tree, overlaps one of another body for which there is no pair. */
    boolean hasNewPair(Leaf leaf, BoundsTree tree) {
        if (!isKnown || !contains(leaf)) {
            explore(tree);
        }
        for (int i = 0; i < others.size(); i++) {
            if (others.get(i).overlaps(leaf) && !leaf.isPairedWith(others.get(i))) {
                return true;
            }
        }
        return false;
    }

    private void explore(BoundsTree tree) {
        minX = minY = Double.POSITIVE_INFINITY;
        maxX = maxY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < body.leaves.size(); i++) {
            surround(this, body.leaves.get(i));
        }
        minX -= MARGIN;
        minY -= MARGIN;
        maxX += MARGIN;
        maxY += MARGIN;
        others.clear();
        TreeNode node = tree.root();
        while (node != null) {
            boolean overlaps = node.overlaps(this);
            if (overlaps && node.left != null) {
                node = node.left;
                continue;
            }
            if (overlaps && ((Leaf) node).body != body) {
                others.add((Leaf) node);
            }
            node = BoundsTree.after(node);
        }
        isKnown = true;
    }
}
