package java.util;

/**
 * Finds objects again by their keys.
 *
 * <p>As on a brick, of two keys that fall into the same of its 32 drawers only the first one is kept.
 */
public class Hashtable {
    private static final int DRAWERS = 32;

    private final Object[] keys = new Object[DRAWERS];
    private final Object[] values = new Object[DRAWERS];

    /** Makes an empty table. */
    public Hashtable() {
    }

    /** Gives the object that was put in with this key, or null. */
    public synchronized Object get(Object key) {
        int drawer = drawerOf(key);
        return keys[drawer] != null && keys[drawer].equals(key) ? values[drawer] : null;
    }

    /** Puts an object in so that it can be found by its key. */
    public synchronized void put(Object key, Object value) {
        int drawer = drawerOf(key);
        if (keys[drawer] == null) keys[drawer] = key;
        if (keys[drawer].equals(key)) values[drawer] = value;
    }

    private static int drawerOf(Object key) {
        return key.hashCode() & DRAWERS - 1;
    }
}
