package java.util;

/**
 * Finds values by their keys; a key must not be null. An older class than HashMap, which can tell its keys.
 *
 * <p>It never has more than 32 places, but finds each key whatever their number is. keys gives the keys in the order
 * of these places.
 */
public class Hashtable<K, V> {
    private static final int PLACES = 32;

    private final Entry<K, V>[] places;

    /** Makes an empty table. */
    public Hashtable() {
        places = newPlaces();
    }

    /**
     * Makes an empty table; the number does not matter.
     *
     * @hidden
     */
    public Hashtable(int capacity) {
        this();
        if (capacity < 0) throw new IllegalArgumentException();
    }

    /** Gives the value of a key, or null if there is no such key. */
    public synchronized V get(Object key) {
        Entry<K, V> entry = find(key);
        return entry == null ? null : entry.value;
    }

    /** Sets the value of a key, and gives the one before, or null. */
    public synchronized V put(K key, V value) {
        Entry<K, V> entry = find(key);
        if (entry == null) {
            append(new Entry<K, V>(key, value));
            return null;
        }
        V old = entry.value;
        entry.value = value;
        return old;
    }

    /** Gives the keys one by one, and null behind the last one. */
    public Enumeration<K> keys() {
        return new Keys();
    }

    /**
     * Takes out a key, and gives its value, or null.
     *
     * @hidden
     */
    public synchronized V remove(Object key) {
        int place = placeOf(key);
        Entry<K, V> before = null;
        for (Entry<K, V> entry = places[place]; entry != null; entry = entry.next) {
            if (key.equals(entry.key)) {
                if (before == null) {
                    places[place] = entry.next;
                } else {
                    before.next = entry.next;
                }
                return entry.value;
            }
            before = entry;
        }
        return null;
    }

    /**
     * Takes all keys out.
     *
     * @hidden
     */
    public synchronized void clear() {
        for (int place = 0; place < PLACES; place++) places[place] = null;
    }

    /**
     * Says whether there is such a key.
     *
     * @hidden
     */
    public synchronized boolean containsKey(Object key) {
        return find(key) != null;
    }

    /**
     * Says whether there is such a value.
     *
     * @hidden
     */
    public synchronized boolean contains(Object value) {
        for (Enumeration<V> all = elements(); all.hasMoreElements();) {
            if (AbstractCollection.isSame(value, all.nextElement())) return true;
        }
        return false;
    }

    /**
     * Gives how many keys there are.
     *
     * @hidden
     */
    public synchronized int size() {
        int count = 0;
        for (Enumeration<K> all = keys(); all.hasMoreElements(); all.nextElement()) count++;
        return count;
    }

    /**
     * Says whether there are no keys.
     *
     * @hidden
     */
    public synchronized boolean isEmpty() {
        return !keys().hasMoreElements();
    }

    /**
     * Gives the values one by one.
     *
     * @hidden
     */
    public Enumeration<V> elements() {
        final Enumeration<K> keys = keys();
        return new Enumeration<V>() {
            public boolean hasMoreElements() {
                return keys.hasMoreElements();
            }

            public V nextElement() {
                return get(keys.nextElement());
            }
        };
    }

    private Entry<K, V> find(Object key) {
        Entry<K, V> entry = places[placeOf(key)];
        while (entry != null && !key.equals(entry.key)) entry = entry.next;
        return entry;
    }

    private void append(Entry<K, V> added) {
        int place = placeOf(added.key);
        if (places[place] == null) {
            places[place] = added;
            return;
        }
        Entry<K, V> last = places[place];
        while (last.next != null) last = last.next;
        last.next = added;
    }

    private static int placeOf(Object key) {
        int rest = key.hashCode() % PLACES;
        return rest < 0 ? rest + PLACES : rest;
    }

    @SuppressWarnings("unchecked")
    private static <K, V> Entry<K, V>[] newPlaces() {
        return (Entry<K, V>[]) new Entry[PLACES];
    }

    private static class Entry<K, V> {
        final K key;
        V value;
        Entry<K, V> next;

        Entry(K key, V value) {
            this.key = key;
            this.value = value;
        }
    }

    /** What is put in while it goes on is told if it comes later. */
    private class Keys implements Enumeration<K> {
        private int place = -1;
        private Entry<K, V> given;

        Keys() {
        }

        public boolean hasMoreElements() {
            if (given != null && given.next != null) return true;
            for (int next = place + 1; next < PLACES; next++) {
                if (places[next] != null) return true;
            }
            return false;
        }

        public K nextElement() {
            given = given == null ? null : given.next;
            while (given == null && place < PLACES - 1) given = places[++place];
            return given == null ? null : given.key;
        }
    }
}
