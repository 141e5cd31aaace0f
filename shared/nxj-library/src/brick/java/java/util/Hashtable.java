package java.util;

/** Finds values by their keys; neither may be null. An older class than HashMap. */
public class Hashtable<K, V> {
    private final KeyTable<K, V> map;

    /** Makes an empty table. */
    public Hashtable() {
        map = new KeyTable<K, V>();
    }

    /** Makes an empty table with room for so many keys; it grows as needed. */
    public Hashtable(int capacity) {
        map = new KeyTable<K, V>(capacity);
    }

    /** Gives the value of a key, or null if there is no such key. */
    public synchronized V get(Object key) {
        return map.get(key);
    }

    /** Sets the value of a key, and gives the one before, or null. */
    public synchronized V put(K key, V value) {
        if (key == null || value == null) throw new NullPointerException();
        return map.put(key, value);
    }

    /** Takes out a key, and gives its value, or null. */
    public synchronized V remove(Object key) {
        return map.remove(key);
    }

    /** Takes all keys out. */
    public synchronized void clear() {
        map.clear();
    }

    /** Says whether there is such a key. */
    public synchronized boolean containsKey(Object key) {
        return map.containsKey(key);
    }

    /** Says whether there is such a value. */
    public synchronized boolean contains(Object value) {
        return map.containsValue(value);
    }

    /** Gives how many keys there are. */
    public synchronized int size() {
        return map.size();
    }

    /** Says whether there are no keys. */
    public synchronized boolean isEmpty() {
        return map.isEmpty();
    }

    /** Gives the keys one by one. */
    public synchronized Enumeration<K> keys() {
        return new Elements<K>(map.keySet().iterator());
    }

    /** Gives the values one by one. */
    public synchronized Enumeration<V> elements() {
        return new Elements<V>(map.values().iterator());
    }

    /** Gives all keys and values as text. */
    public synchronized String toString() {
        return map.toString();
    }

    private static class Elements<E> implements Enumeration<E> {
        private final Iterator<E> elements;

        Elements(Iterator<E> elements) {
            this.elements = elements;
        }

        public boolean hasMoreElements() {
            return elements.hasNext();
        }

        public E nextElement() {
            return elements.next();
        }
    }
}
