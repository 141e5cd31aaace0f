package java.util;

/** What a Hashtable keeps its keys and values in; they are in no particular order. */
class KeyTable<K, V> extends AbstractMap<K, V> {
    private Node<K, V>[] table;
    private final float loadFactor;
    private int count;
    private int modCount;

    /** Makes an empty map. */
    KeyTable() {
        this(16);
    }

    /** Makes an empty map with room for so many keys; it grows as needed. */
    KeyTable(int capacity) {
        this(capacity, 0.75f);
    }

    /** Makes an empty map with room for so many keys, which grows when this part of it is used. */
    KeyTable(int capacity, float loadFactor) {
        if (capacity < 0 || !(loadFactor > 0)) throw new IllegalArgumentException();
        int size = 1;
        while (size < capacity) size <<= 1;
        table = newTable(size);
        this.loadFactor = loadFactor;
    }

    /** Gives how many keys there are. */
    public int size() {
        return count;
    }

    /** Says whether there is such a key. */
    public boolean containsKey(Object key) {
        return find(key) != null;
    }

    /** Gives the value of a key, or null if there is no such key. */
    public V get(Object key) {
        Node<K, V> node = find(key);
        return node == null ? null : node.value;
    }

    /** Sets the value of a key, and gives the one before, or null. */
    public V put(K key, V value) {
        Node<K, V> node = find(key);
        if (node != null) return node.setValue(value);
        modCount++;
        count++;
        if (count > table.length * loadFactor) grow();
        int hash = hash(key);
        int place = hash & table.length - 1;
        table[place] = new Node<K, V>(key, value, hash, table[place]);
        return null;
    }

    /** Takes out a key, and gives its value, or null. */
    public V remove(Object key) {
        int hash = hash(key);
        int place = hash & table.length - 1;
        Node<K, V> previous = null;
        for (Node<K, V> node = table[place]; node != null; node = node.next) {
            if (node.hash == hash && AbstractCollection.isSame(key, node.key)) {
                if (previous == null) {
                    table[place] = node.next;
                } else {
                    previous.next = node.next;
                }
                modCount++;
                count--;
                return node.value;
            }
            previous = node;
        }
        return null;
    }

    /** Takes all keys out. */
    public void clear() {
        modCount++;
        count = 0;
        for (int place = 0; place < table.length; place++) table[place] = null;
    }

    /** Gives the keys with their values; what is taken out of them is taken out of the map. */
    public Set<Map.Entry<K, V>> entrySet() {
        return new Entries();
    }

    private Node<K, V> find(Object key) {
        int hash = hash(key);
        for (Node<K, V> node = table[hash & table.length - 1]; node != null; node = node.next) {
            if (node.hash == hash && AbstractCollection.isSame(key, node.key)) return node;
        }
        return null;
    }

    private void grow() {
        Node<K, V>[] old = table;
        table = newTable(2 * old.length);
        for (int place = 0; place < old.length; place++) {
            Node<K, V> node = old[place];
            while (node != null) {
                Node<K, V> next = node.next;
                int newPlace = node.hash & table.length - 1;
                node.next = table[newPlace];
                table[newPlace] = node;
                node = next;
            }
        }
    }

    private static int hash(Object key) {
        int hash = key == null ? 0 : key.hashCode();
        hash ^= hash >>> 16;
        return hash ^ hash >>> 8;
    }

    @SuppressWarnings("unchecked")
    private static <K, V> Node<K, V>[] newTable(int size) {
        return (Node<K, V>[]) new Node[size];
    }

    private static class Node<K, V> implements Map.Entry<K, V> {
        final K key;
        final int hash;
        V value;
        Node<K, V> next;

        Node(K key, V value, int hash, Node<K, V> next) {
            this.key = key;
            this.value = value;
            this.hash = hash;
            this.next = next;
        }

        public K getKey() {
            return key;
        }

        public V getValue() {
            return value;
        }

        public V setValue(V value) {
            V old = this.value;
            this.value = value;
            return old;
        }

        public boolean equals(Object other) {
            if (!(other instanceof Map.Entry)) return false;
            Map.Entry<?, ?> entry = (Map.Entry<?, ?>) other;
            return AbstractCollection.isSame(key, entry.getKey()) && AbstractCollection.isSame(value, entry.getValue());
        }

        public int hashCode() {
            return (key == null ? 0 : key.hashCode()) ^ (value == null ? 0 : value.hashCode());
        }

        public String toString() {
            return key + "=" + value;
        }
    }

    private class Entries extends AbstractSet<Map.Entry<K, V>> {
        Entries() {
        }

        public int size() {
            return count;
        }

        public boolean contains(Object other) {
            if (!(other instanceof Map.Entry)) return false;
            Node<K, V> node = find(((Map.Entry<?, ?>) other).getKey());
            return node != null && node.equals(other);
        }

        public void clear() {
            KeyTable.this.clear();
        }

        public Iterator<Map.Entry<K, V>> iterator() {
            return new Nodes();
        }
    }

    private class Nodes implements Iterator<Map.Entry<K, V>> {
        private int place;
        private Node<K, V> next;
        private Node<K, V> given;
        private int expectedModCount = modCount;

        Nodes() {
            findNext();
        }

        public boolean hasNext() {
            return next != null;
        }

        public Map.Entry<K, V> next() {
            if (expectedModCount != modCount) throw new ConcurrentModificationException();
            if (next == null) throw new NoSuchElementException();
            given = next;
            next = next.next;
            findNext();
            return given;
        }

        public void remove() {
            if (given == null) throw new IllegalStateException();
            if (expectedModCount != modCount) throw new ConcurrentModificationException();
            KeyTable.this.remove(given.key);
            given = null;
            expectedModCount = modCount;
        }

        private void findNext() {
            while (next == null && place < table.length) next = table[place++];
        }
    }
}
