package java.util;

/**
 * Finds values by their keys.
 *
 * <p>On a brick, nothing gives all keys or values: keySet, values, entrySet and containsValue fail with
 * UnsupportedOperationException, and so does what needs them. Keep the keys in a list of your own. A key must not be
 * null, and its hashCode must not be below 0, as it is for some texts: then the brick fails with
 * ArrayIndexOutOfBoundsException.
 */
public class HashMap<K, V> implements Map<K, V> {
    private static final int PLACES = 32;

    private final Entry<K, V>[] places;
    private int count;

    /** Makes an empty map. */
    public HashMap() {
        this(PLACES);
    }

    /** Makes an empty map with so many places; it never has more, but finds each key whatever their number is. */
    public HashMap(int places) {
        this.places = newPlaces(places);
    }

    /**
     * Makes an empty map with so many places; the other number does not matter.
     *
     * @hidden
     */
    public HashMap(int places, float loadFactor) {
        this(places);
    }

    /** Fails: a brick cannot read all keys of another map. */
    public HashMap(Map<K, V> other) {
        this(other, PLACES);
    }

    /** Fails: a brick cannot read all keys of another map. */
    public HashMap(Map<K, V> other, int places) {
        this(places);
        putAll(other);
    }

    /** Gives how many keys there are. */
    public int size() {
        return count;
    }

    /** Says whether there are no keys. */
    public boolean isEmpty() {
        return count == 0;
    }

    /** Says whether there is such a key. */
    public boolean containsKey(Object key) {
        return find(key) != null;
    }

    /** Fails with UnsupportedOperationException: a brick cannot go through the values. */
    public boolean containsValue(Object value) {
        return values().contains(value);
    }

    /** Gives the value of a key, or null if there is no such key. */
    public V get(Object key) {
        Entry<K, V> entry = find(key);
        return entry == null ? null : entry.value;
    }

    /** Sets the value of a key, and gives the one before, or null. */
    public V put(K key, V value) {
        Entry<K, V> entry = find(key);
        if (entry != null) return entry.setValue(value);
        int place = placeOf(key);
        places[place] = new Entry<K, V>(key, value, places[place]);
        count++;
        return null;
    }

    /** Fails if the other one is a HashMap, which cannot tell its keys. */
    public void putAll(Map<? extends K, ? extends V> other) {
        for (Map.Entry<? extends K, ? extends V> entry : other.entrySet()) put(entry.getKey(), entry.getValue());
    }

    /** Takes out a key, and gives its value, or null. */
    public V remove(Object key) {
        int place = placeOf(key);
        Entry<K, V> before = null;
        for (Entry<K, V> entry = places[place]; entry != null; entry = entry.next) {
            if (key.equals(entry.key)) {
                if (before == null) {
                    places[place] = entry.next;
                } else {
                    before.next = entry.next;
                }
                count--;
                return entry.value;
            }
            before = entry;
        }
        return null;
    }

    /** Takes all keys out. */
    public void clear() {
        for (int place = 0; place < places.length; place++) places[place] = null;
        count = 0;
    }

    /** Fails with UnsupportedOperationException: keep the keys in a list of your own. */
    public Set<K> keySet() {
        throw new UnsupportedOperationException();
    }

    /** Fails with UnsupportedOperationException: keep the values in a list of your own. */
    public Collection<V> values() {
        throw new UnsupportedOperationException();
    }

    /** Fails with UnsupportedOperationException: keep the keys in a list of your own. */
    public Set<Map.Entry<K, V>> entrySet() {
        throw new UnsupportedOperationException();
    }

    /** Says whether both are the very same map; fails if the other one is a map of the same size. */
    public boolean equals(Object other) {
        if (other == this) return true;
        if (!(other instanceof Map) || ((Map<?, ?>) other).size() != count) return false;
        throw new UnsupportedOperationException();
    }

    /** Fails with UnsupportedOperationException: a brick cannot go through the keys. */
    public int hashCode() {
        throw new UnsupportedOperationException();
    }

    private Entry<K, V> find(Object key) {
        for (Entry<K, V> entry = places[placeOf(key)]; entry != null; entry = entry.next) {
            if (key.equals(entry.key)) return entry;
        }
        return null;
    }

    /** Where the key is looked for; below 0 if its hash code is, as on a brick. */
    private int placeOf(Object key) {
        return key.hashCode() % places.length;
    }

    @SuppressWarnings("unchecked")
    private static <K, V> Entry<K, V>[] newPlaces(int count) {
        return (Entry<K, V>[]) new Entry[count];
    }

    /** A key with its value. */
    public static class Entry<K, V> implements Map.Entry<K, V> {
        final K key;
        V value;
        Entry<K, V> next;

        Entry(K key, V value, Entry<K, V> next) {
            this.key = key;
            this.value = value;
            this.next = next;
        }

        /** Gives the key. */
        public final K getKey() {
            return key;
        }

        /** Gives the value. */
        public final V getValue() {
            return value;
        }

        /** Sets the value, and gives the one before. */
        public final V setValue(V value) {
            V old = this.value;
            this.value = value;
            return old;
        }

        /** Says whether the other one is the same key with the same value. */
        public final boolean equals(Object other) {
            if (!(other instanceof Map.Entry)) return false;
            Map.Entry<?, ?> entry = (Map.Entry<?, ?>) other;
            return AbstractCollection.isSame(key, entry.getKey()) && AbstractCollection.isSame(value, entry.getValue());
        }

        /** Gives a number that is the same for the same key and value. */
        public final int hashCode() {
            return (key == null ? 0 : key.hashCode()) ^ (value == null ? 0 : value.hashCode());
        }

        /** Gives the key and the value as text. */
        public final String toString() {
            return key + "=" + value;
        }
    }
}
