package java.util;

/** Finds values by their keys. */
public interface Map<K, V> {
    /** Gives how many keys there are. */
    int size();

    /** Says whether there are no keys. */
    boolean isEmpty();

    /** Says whether there is such a key. */
    boolean containsKey(Object key);

    /** Says whether there is such a value. */
    boolean containsValue(Object value);

    /** Gives the value of a key, or null if there is no such key. */
    V get(Object key);

    /** Sets the value of a key, and gives the one before, or null. */
    V put(K key, V value);

    /** Sets all keys and values of the other map. */
    void putAll(Map<? extends K, ? extends V> other);

    /** Takes out a key, and gives its value, or null. */
    V remove(Object key);

    /** Takes all keys out. */
    void clear();

    /** Gives the keys; what is taken out of them is taken out of the map. */
    Set<K> keySet();

    /** Gives the values; what is taken out of them is taken out of the map. */
    Collection<V> values();

    /** Gives the keys with their values; what is taken out of them is taken out of the map. */
    Set<Map.Entry<K, V>> entrySet();

    /** A key with its value. */
    interface Entry<K, V> {
        /** Gives the key. */
        K getKey();

        /** Gives the value. */
        V getValue();

        /** Sets the value, and gives the one before. */
        V setValue(V value);
    }
}
